#pragma once
// A body as result files hold it: numbered within itself, its rows spread over the ranks.

#include <string>

#include "idiophone/foundation/parallel/rows.hpp"
#include "idiophone/run/results/result_file.hpp"
#include "idiophone/solids/mesh/part.hpp"

namespace idiophone::record {

class StoredBody {
 public:
  /// Collective.
  /// @param part     this rank's; must outlive this object, as must `offsets`
  /// @param offsets  first global numbers of each body
  /// @param number   of the body
  StoredBody(std::string name, const mesh::Part& part, const mesh::Offsets& offsets, std::size_t number,
             MPI_Comm communicator);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const parallel::Rows& nodes() const {
    return nodes_;
  }  ///< rows are its owned nodes, in the part's order

  /// Adds its undeformed mesh to a new result. Collective.
  void add_mesh(results::ResultFile& result) const;

 private:
  std::string name_;
  const mesh::Part& part_;
  const mesh::BodyPart& body_;
  Index first_node_;  ///< global number
  parallel::Rows nodes_;
  parallel::Rows cells_;  ///< that the owned elements are drawn as
};

}  // namespace idiophone::record
