#pragma once
// One visitor that saves and restores: a class names each piece of its state once, in archive(), and the kind of
// archive decides which way the values go.

#include <mpi.h>

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "idiophone/foundation/parallel/archive_row.hpp"
#include "idiophone/foundation/parallel/reproducible_sum.hpp"
#include "idiophone/foundation/parallel/rows.hpp"

namespace idiophone::parallel {

/// Names are paths: "motion/nodes". All calls are collective and in the same order on all ranks.
class Archive {
 public:
  explicit Archive(MPI_Comm communicator) : communicator_(communicator) {}
  virtual ~Archive() = default;
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;
  Archive(Archive&&) = delete;
  Archive& operator=(Archive&&) = delete;

  /// Whether values come out of the archive; otherwise they go in.
  [[nodiscard]] virtual bool restoring() const = 0;
  [[nodiscard]] MPI_Comm communicator() const { return communicator_; }

  /// State spread over the ranks. It may be restored on another number of ranks. Rows without numbers are left out.
  /// @param visit  visit(local row, ArchiveRow&) names the numbers of a row, as many in every row
  template <class Visitor>
  void rows(const std::string& name, const Rows& rows, Visitor visit) {
    ArchiveRow first(ArchiveRow::Action::count);
    if (rows.local_rows() > 0) {
      visit(std::size_t{0}, first);
    }
    const std::size_t width = largest_width(first.count());
    if (width == 0) {
      return;
    }
    std::vector<double> values(width * rows.local_rows());
    const auto visit_all = [&](ArchiveRow::Action action) {
      for (std::size_t row = 0; row * width < values.size(); ++row) {
        ArchiveRow numbers(action, std::span(values).subspan(row * width, width));
        visit(row, numbers);
      }
    };
    if (!restoring()) {
      visit_all(ArchiveRow::Action::save);
    }
    exchange_rows(name, rows, static_cast<int>(width), values);
    if (restoring()) {
      visit_all(ArchiveRow::Action::restore);
    }
  }

  /// State that rank 0 knows when it is saved; every rank gets it.
  void root(const std::string& name, std::vector<double>& values) { exchange_root(name, values); }
  void root(const std::string& name, std::vector<std::int64_t>& values) { exchange_root(name, values); }
  /// @throws std::runtime_error when the archive does not hold exactly one value
  void root(const std::string& name, double& value);
  void root(const std::string& name, std::int64_t& value);

  /// A sum of which each rank has a share: the total is saved, and becomes rank 0's share.
  void sum(const std::string& name, ReproducibleSum& share);

 protected:
  virtual void exchange_rows(const std::string& name, const Rows& rows, int width, std::vector<double>& values) = 0;
  virtual void exchange_root(const std::string& name, std::vector<double>& values) = 0;
  virtual void exchange_root(const std::string& name, std::vector<std::int64_t>& values) = 0;

 private:
  /// Collective; ranks without rows do not know the width.
  [[nodiscard]] std::size_t largest_width(std::size_t here) const;

  MPI_Comm communicator_;
};

/// Keeps the names alone.
class ArchiveNames : public Archive {
 public:
  using Archive::Archive;
  [[nodiscard]] bool restoring() const override { return false; }
  [[nodiscard]] const std::set<std::string>& names() const { return names_; }

 protected:
  void exchange_rows(const std::string& name, const Rows& rows, int width, std::vector<double>& values) override;
  void exchange_root(const std::string& name, std::vector<double>& values) override;
  void exchange_root(const std::string& name, std::vector<std::int64_t>& values) override;

 private:
  /// @throws std::logic_error when a name is taken
  void add(const std::string& name);
  std::set<std::string> names_;
};

}  // namespace idiophone::parallel
