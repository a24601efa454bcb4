#include "bench_session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "idiophone/study/bench/tap_place.hpp"
#include "idiophone/study/mode_kinds/mode_kinds.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::app {

namespace {

/// "mode 3 (torsion 1)"
std::string name_of(const bench::Workpiece& piece, std::size_t mode) {
  std::vector<std::vector<double>> shapes;
  std::ranges::transform(piece.uncut().modes, std::back_inserter(shapes), &eigenmodes::Mode::shape);
  const std::string kind = mode_kinds::kinds_of(piece.uncut().mesh.nodes, shapes)[mode];
  return kind.empty() ? fmt::format("mode {}", mode + 1) : fmt::format("mode {} ({})", mode + 1, kind);
}

/// What may be, without what to do.
std::string question_of(const bench::Workpiece& piece, const bench::Doubt& doubt) {
  const std::string mode = name_of(piece, doubt.mode);
  if (doubt.other) {
    return fmt::format("the line at {:.2f} Hz may be that of {} or of {}", doubt.line, mode,
                       name_of(piece, *doubt.other));
  }
  if (doubt.other_line) {
    return fmt::format("{} may have the line at {:.2f} or that at {:.2f} Hz", mode, doubt.line, *doubt.other_line);
  }
  return fmt::format(
      "the line of {} at {:.2f} Hz is {:.1f} standard deviations {} where it was expected: the tap, the depth of a cut "
      "or the deck is wrong",
      mode, doubt.line, std::abs(doubt.surprise), doubt.surprise > 0 ? "above" : "below");
}

/// "Tap at 0.17,0,0 m, where ..."
std::string request_of(const Vector3& place, std::size_t mode, std::optional<std::size_t> other) {
  const std::string there = fmt::format("{:.4g},{:.4g},{:.4g}", place.x(), place.y(), place.z());
  return fmt::format("Tap at {} m, where mode {} moves{}, and give --tapped-at={}", there, mode + 1,
                     other ? fmt::format(" and mode {} hardly does", *other + 1) : " most", there);
}

/// What may be, and the measurement that decides.
std::string sentence_of(const bench::Workpiece& piece, const bench::Doubt& doubt, const std::optional<Vector3>& place) {
  if (!place) {
    const bool is_choice = doubt.other || doubt.other_line;
    return question_of(piece, doubt) + (is_choice ? ". No place for a tap tells them apart: measure more exactly, or "
                                                    "give only the lines of the modes to be tuned in a YAML file"
                                                  : ". Tap again");
  }
  return fmt::format("{}. {}", question_of(piece, doubt), request_of(*place, doubt.mode, doubt.other));
}

void doubt_lines(BenchSession& session, const bench::Workpiece& piece) {
  if (session.learned && session.learned->doubt) {
    const bench::Doubt& doubt = *session.learned->doubt;
    session.decisive = bench::deciding_place(piece.uncut(), piece.side(), doubt.mode, doubt.other);
    session.doubt = sentence_of(piece, doubt, session.decisive);
  }
}

/// Of the lines that are carried over, asks for the one that is known worst.
void ask_for_carried_lines(BenchSession& session, const bench::Workpiece& piece) {
  const auto doubt_of = [](const BenchPartial& partial) { return partial.carried ? partial.line->uncertainty : -1.0; };
  const BenchPartial& worst = *std::ranges::max_element(session.partials, {}, doubt_of);
  if (session.doubt.empty() && worst.carried) {
    const auto mode = static_cast<std::size_t>(worst.mode) - 1;
    session.decisive = bench::deciding_place(piece.uncut(), piece.side(), mode, {});
    session.renewal = session.decisive ? request_of(*session.decisive, mode, {}) : "";
  }
}

void set_wanted(std::vector<BenchPartial>& partials, const fitting::Target& target) {
  const double unit = target.are_ratios ? partials.front().frequency() / target.values.front() : 1.0;
  for (std::size_t p = 0; p < partials.size(); ++p) {
    partials[p].wanted = unit * target.values[p];
  }
}

BenchSession without_taps(const bench::Workpiece& piece, const std::vector<int>& numbers, const bench::Past& past) {
  BenchSession session;
  session.cuts = past.cuts;
  session.body = piece.with(past.cuts);
  for (std::size_t p = 0; p < numbers.size(); ++p) {
    session.partials.push_back({.mode = numbers[p], .computed = session.body.modes[session.body.tuned[p]].frequency});
  }
  return session;
}

BenchSession with_taps(bench::Workpiece& piece, const BenchSubject& subject, const bench::Past& past,
                       const bench::Beliefs& beliefs) {
  BenchSession session;
  session.learned = bench::learn(piece, past.cuts, past.taps, beliefs);
  const bench::Learned& learned = *session.learned;
  doubt_lines(session, piece);
  for (std::size_t p = 0; p < subject.numbers.size(); ++p) {
    const int number = subject.numbers[p];
    if (!learned.lines[p] && !learned.is_doubted[p]) {
      throw std::runtime_error(fmt::format("{}: mode {}, computed at {:.1f} Hz, was not measured. {}",
                                           subject.measured.string(), number, learned.computed[p],
                                           session.doubt.empty()
                                               ? "Tap where it moves much, give its line in a YAML file, correct the "
                                                 "deck by `identify`, or allow more by --match"
                                               : "Besides, " + session.doubt));
    }
    session.partials.push_back(
        {.mode = number, .computed = learned.computed[p], .line = learned.lines[p], .carried = learned.carried[p]});
  }
  ask_for_carried_lines(session, piece);
  if (learned.material) {
    piece.take(*learned.material);
  }
  session.cuts = learned.cuts;
  session.body = piece.with(learned.cuts);
  return session;
}

}  // namespace

BenchSession begin_session(bench::Workpiece& piece, const BenchSubject& subject, const bench::Past& past,
                           const fitting::Target& target, const bench::Beliefs& beliefs) {
  BenchSession session =
      past.taps.empty() ? without_taps(piece, subject.numbers, past) : with_taps(piece, subject, past, beliefs);
  set_wanted(session.partials, target);
  return session;
}

bench::Partials distances_of(const std::vector<BenchPartial>& partials, bool are_ratios) {
  const auto count = static_cast<Eigen::Index>(partials.size());
  bench::Partials result{Eigen::VectorXd(count), Eigen::VectorXd(count), are_ratios};
  std::ranges::transform(partials, std::back_inserter(result.carried),
                         [](const BenchPartial& partial) { return partial.carried.has_value(); });
  for (Eigen::Index p = 0; p < count; ++p) {
    const BenchPartial& partial = partials[static_cast<std::size_t>(p)];
    result.cents[p] = partials::cents(partial.frequency(), partial.wanted);
    result.uncertainties[p] = partial.line ? partial.line->uncertainty : 0.0;
  }
  return result;
}

}  // namespace idiophone::app
