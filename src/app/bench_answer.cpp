#include "bench_answer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "idiophone/study/bench/cut_list.hpp"
#include "idiophone/study/partials/compare.hpp"

namespace idiophone::app {

namespace {

using bench::Cut;
using bench::Plan;
using bench::Verdict;
using nlohmann::json;

constexpr double per_millimetre = 1e-3;  // m
constexpr int shown_places = 13;         // along the body

std::vector<double> list_of(const Eigen::VectorXd& vector) {
  return {vector.begin(), vector.end()};
}

/// Where the effect of a tool is shown, m: evenly from end to end, as far as its cuts lie within the body.
std::vector<double> places_shown(const bench::Strips& strips, const bench::Tool& tool) {
  const double low = strips.low() + tool.radius;
  const double high = strips.high() - tool.radius;
  std::vector<double> places;
  for (int i = 0; i < shown_places && low < high; ++i) {
    places.push_back(low + (high - low) * i / (shown_places - 1));
  }
  return places;
}

void print_heads(const std::vector<BenchPartial>& partials) {
  for (const BenchPartial& partial : partials) {
    fmt::print("  {:>9}", fmt::format("mode {}", partial.mode));
  }
  fmt::print("\n");
}

void print_cents(const Eigen::VectorXd& cents) {
  for (const double value : cents) {
    fmt::print("  {:>+9.2f}", value);
  }
  fmt::print("\n");
}

/// The cuts and taps so far, and the cuts to make now.
bench::Past past_then(const BenchAnswer& answer) {
  bench::Past past = answer.past;
  if (!answer.plan.visits.empty()) {
    const std::vector<Cut>& next = answer.plan.visits.front().cuts;
    past.cuts.insert(past.cuts.end(), next.begin(), next.end());
  }
  return past;
}

json to_json(const std::vector<Cut>& cuts) {
  json list = json::array();
  for (const Cut& cut : cuts) {
    list.push_back({{"tool", cut.tool.name},
                    {"place", cut.place},
                    {"width", 2 * cut.tool.radius},
                    {"depth", cut.depth},
                    {"cents", list_of(cut.cents)}});
  }
  return list;
}

void print_distances(const BenchAnswer& answer) {
  fmt::print("{:>4}  {:>12}  {:>12}  {:>11}  {:>12}  {:>13}\n", "mode", "computed/Hz", "measured/Hz", "shift/cents",
             "wanted/Hz", "missing/cents");
  for (std::size_t p = 0; p < answer.session.partials.size(); ++p) {
    const BenchPartial& partial = answer.session.partials[p];
    fmt::print("{:>4}  {:>12.3f}  ", partial.mode, partial.computed);
    if (partial.line) {
      fmt::print("{:>12.3f}  {:>+11.2f}", partial.line->frequency,
                 partials::cents(partial.line->frequency, partial.computed));
    } else {
      fmt::print("{:>12}  {:>11}", "-", "-");
    }
    fmt::print("  {:>12.3f}  {:>+13.2f}\n", partial.wanted, 0.0 - answer.plan.errors[static_cast<Eigen::Index>(p)]);
  }
}

/// "that of tap 1, moved by -3.20 cents by 2 cuts, +- 0.41"
std::string origin_of(const BenchPartial& partial, const bench::Past& past) {
  const std::size_t cuts = past.cuts.size() - past.taps[partial.carried->tap].cuts;
  const std::string cause = cuts == 0 ? "" : fmt::format(" by {} cut{}", cuts, cuts == 1 ? "" : "s");
  return fmt::format("that of tap {}, moved by {:+.2f} cents{}, +- {:.2f}", partial.carried->tap + 1,
                     partial.carried->moved, cause, partial.line->uncertainty);
}

void print_carried(const BenchAnswer& answer) {
  for (const BenchPartial& partial : answer.session.partials) {
    if (partial.carried) {
      fmt::print("the last tap has no line of mode {}: the line is {}\n", partial.mode,
                 origin_of(partial, answer.past));
    }
  }
}

json carried_over(const BenchPartial& partial) {
  if (!partial.carried) {
    return {};
  }
  return {
      {"tap", partial.carried->tap + 1}, {"moved", partial.carried->moved}, {"uncertainty", partial.line->uncertainty}};
}

void print_learned(const BenchAnswer& answer) {
  if (!answer.session.learned) {
    return;
  }
  const bench::Learned& learned = *answer.session.learned;
  fmt::print("\n{:<16}  {:>9}  {:>9}\n", "by the taps", "change", "deviation");
  for (const bench::Estimate& constant : learned.constants) {
    fmt::print("{:<16}  {:>+9.3f}  {:>9.3f}\n", constant.name, constant.expected, constant.deviation);
  }
  for (std::size_t cut = 0; cut < learned.depths.size(); ++cut) {
    fmt::print("{:<16}  {:>+9.3f}  {:>9.3f}\n", fmt::format("depth {}/mm", cut + 1), 1e3 * learned.depths[cut].expected,
               1e3 * learned.depths[cut].deviation);
  }
}

json to_json(const std::optional<bench::Learned>& learned) {
  if (!learned) {
    return {};
  }
  json facts = {{"probability", learned->probability}, {"constants", json::array()}, {"depths", json::array()}};
  for (const bench::Estimate& constant : learned->constants) {
    facts["constants"].push_back(
        {{"name", constant.name}, {"change", constant.expected}, {"deviation", constant.deviation}});
  }
  for (const bench::Estimate& depth : learned->depths) {
    facts["depths"].push_back({{"change", depth.expected}, {"deviation", depth.deviation}});
  }
  return facts;
}

void print_effects(const BenchAnswer& answer) {
  const bench::Tool& tool = answer.tools.front();
  fmt::print("\ncents of a cut of 1 mm by {}:{:g} at the side {}\n{:>10}", tool.name, tool.radius, name_of(answer.side),
             fmt::format("{}/mm", axis_name(answer.side)));
  print_heads(answer.session.partials);
  for (const double place : places_shown(answer.strips, tool)) {
    fmt::print("{:>10.1f}", place * 1e3);
    print_cents(per_millimetre * slopes_of(answer.strips, tool, place));
  }
}

void print_cuts(const BenchAnswer& answer) {
  fmt::print("\n{:<8}  {:>8}  {:>8}  {:>8}", "next cut", fmt::format("{}/mm", axis_name(answer.side)), "width/mm",
             "depth/mm");
  print_heads(answer.session.partials);
  const bench::Visit& next = answer.plan.visits.front();
  for (const Cut& cut : next.cuts) {
    fmt::print("{:<8}  {:>8.1f}  {:>8.1f}  {:>8.2f}", cut.tool.name, cut.place * 1e3, 2 * cut.tool.radius * 1e3,
               cut.depth * 1e3);
    print_cents(cut.cents);
  }
  fmt::print("{:<38}", "cents from the target then");
  print_cents(next.expected);
  fmt::print("{:<38}", "standard deviation");
  print_cents(next.uncertainties);
}

void print_later_visits(const BenchAnswer& answer) {
  for (std::size_t visit = 1; visit < answer.plan.visits.size(); ++visit) {
    const std::size_t cuts = answer.plan.visits[visit].cuts.size();
    fmt::print("{:<38}", fmt::format("after tap {} and {} more cut{}", visit, cuts, cuts == 1 ? "" : "s"));
    print_cents(answer.plan.visits[visit].expected);
  }
}

void print_list(const BenchAnswer& answer) {
  fmt::print("\nfor --cuts, when these are made:\n{}", bench::text_of(past_then(answer), answer.side));
}

}  // namespace

std::string word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::in_tune:
      return "in_tune";
    case Verdict::ambiguous:
      return "ambiguous";
    case Verdict::cut:
      return "cut";
    case Verdict::not_safe:
      return "not_safe";
    case Verdict::out_of_reach:
      return "out_of_reach";
  }
  return "";
}

std::string advice(const BenchAnswer& answer) {
  const Plan& plan = answer.plan;
  switch (plan.verdict) {
    case Verdict::in_tune:
      return "all partials are within the tolerance";
    case Verdict::ambiguous:
      return answer.session.doubt;
    case Verdict::cut:
      return "make these cuts, and tap again";
    case Verdict::not_safe:
      if (!plan.is_settled) {
        return "the cuts that the slopes allow pass a target in the solved body, even where they are as shallow as "
               "--depth-error: choose other tools, or another side";
      }
      if (!plan.is_measured && !answer.session.renewal.empty()) {
        return "a line that is carried over is too uncertain. " + answer.session.renewal;
      }
      return "any cut may pass a target: give a smaller --depth-error, a tool with a smaller radius, or more exact "
             "measurements";
    case Verdict::out_of_reach:
      break;
  }
  Eigen::Index worst = 0;
  plan.unreachable.cwiseAbs().maxCoeff(&worst);
  const double cents = plan.unreachable[worst];
  return fmt::format(
      "no removal at the side {} reaches the targets: mode {} stays {:.1f} cents too {} at best. Choose another side, "
      "other tools, or a lower target",
      name_of(answer.side), answer.session.partials[worst].mode, std::abs(cents), cents > 0 ? "high" : "low");
}

void print(const BenchAnswer& answer) {
  print_distances(answer);
  print_carried(answer);
  print_learned(answer);
  print_effects(answer);
  if (!answer.plan.visits.empty()) {
    print_cuts(answer);
    print_later_visits(answer);
  }
  if (!answer.plan.visits.empty() || !answer.past.taps.empty()) {
    print_list(answer);
  }
  fmt::print("\n{}\n", advice(answer));
}

json to_json(const BenchAnswer& answer) {
  const Plan& plan = answer.plan;
  json facts = {{"body", answer.body},
                {"verdict", word_of(plan.verdict)},
                {"advice", advice(answer)},
                {"side", name_of(answer.side)},
                {"along", std::string(1, axis_name(answer.side))},
                {"learned", to_json(answer.session.learned)},
                {"tap_at", json()},
                {"partials", json::array()},
                {"effects", json::array()},
                {"visits", json::array()}};
  if (answer.session.decisive) {
    facts["tap_at"] = {answer.session.decisive->x(), answer.session.decisive->y(), answer.session.decisive->z()};
  }
  const Eigen::VectorXd& expected = plan.visits.empty() ? plan.errors : plan.visits.front().expected;
  const Eigen::VectorXd& uncertainties = plan.visits.empty() ? plan.measured : plan.visits.front().uncertainties;
  for (std::size_t p = 0; p < answer.session.partials.size(); ++p) {
    const BenchPartial& partial = answer.session.partials[p];
    const auto place = static_cast<Eigen::Index>(p);
    facts["partials"].push_back(
        {{"mode", partial.mode},
         {"computed", partial.computed},
         {"measured", partial.line ? json(partial.line->frequency) : json()},
         {"shift", partial.line ? json(partials::cents(partial.line->frequency, partial.computed)) : json()},
         {"carried_over", carried_over(partial)},
         {"wanted", partial.wanted},
         {"missing", 0.0 - plan.errors[place]},
         {"expected", expected[place]},
         {"uncertainty", uncertainties[place]},
         {"unreachable", plan.unreachable[place]}});
  }
  for (const bench::Tool& tool : answer.tools) {
    for (const double place : places_shown(answer.strips, tool)) {
      facts["effects"].push_back(
          {{"tool", tool.name},
           {"radius", tool.radius},
           {"place", place},
           {"cents_per_millimetre", list_of(per_millimetre * slopes_of(answer.strips, tool, place))}});
    }
  }
  facts["cuts"] = plan.visits.empty() ? json::array() : to_json(plan.visits.front().cuts);
  for (const bench::Visit& visit : plan.visits) {
    facts["visits"].push_back({{"cuts", to_json(visit.cuts)}, {"expected", list_of(visit.expected)}});
  }
  facts["cuts_file"] = bench::text_of(past_then(answer), answer.side);
  return facts;
}

}  // namespace idiophone::app
