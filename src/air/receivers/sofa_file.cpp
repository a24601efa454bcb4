#include "sofa_file.hpp"

#include "idiophone/files/reading_limit.hpp"

namespace idiophone::receivers {

SofaFile open_sofa_file(const std::filesystem::path& file, int rate) {
  const files::ReadingLimit limit(file);  // libmysofa believes the sizes that a damaged file tells
  SofaFile opened;
  opened.contents = mysofa_open_no_norm(file.c_str(), static_cast<float>(rate), &opened.taps, &opened.error);
  return opened;
}

}  // namespace idiophone::receivers
