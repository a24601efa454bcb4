#include "tuning_answer.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ranks.hpp"

namespace idiophone::app {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

ON_RANKS(1);

TEST(TuningAnswer, HasNoSensitivitiesThatAreNotKnown) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const fitting::Tuning tuning{.values = {0.2},
                               .bounds = {fitting::Bound::none},
                               .modes = {{.start_mode = 1, .mode = 1, .similarity = 1}},
                               .sensitivities = {{unknown}},
                               .decays = {{.sensitivities = {unknown}}},
                               .levels = {{.wanted = {}, .sensitivities = {2000}}}};
  const std::vector<fitting::Variable> variables = {{"bar.length", 0.1, 0.3, 0.2}};
  const std::optional<InTune> in_tune;
  const TuningAnswer answer{tuning, variables, in_tune};
  const nlohmann::json facts = to_json(answer);
  for (const char* table : {"modes", "decays"}) {
    EXPECT_TRUE(facts.at(table).at(0).at("sensitivities").at("bar.length").is_null()) << table;
  }
  EXPECT_EQ(facts.at("levels").at(0).at("sensitivities").at("bar.length"), 2000);
  ::testing::internal::CaptureStdout();
  print(answer);
  EXPECT_THAT(::testing::internal::GetCapturedStdout(),
              AllOf(HasSubstr("1.000" + std::string(13, ' ') + "-  "), HasSubstr("+2.0000"), Not(HasSubstr("nan"))));
}

}  // namespace
}  // namespace idiophone::app
