// The table of commands, and the options that they share.

#include "commands.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "command_line.hpp"
#include "ranks.hpp"

namespace idiophone::app {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

/// What is said of a command line that is refused; "accepted" where it is not.
std::string refusal(const std::string& arguments) {
  CommandLine line;
  try {
    line.parser().parse(arguments);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return "accepted";
}

Style style_of(const std::string& arguments) {
  CommandLine line;
  line.parser().parse(arguments);
  return line.command().style();
}

ON_RANKS(1);

TEST(Commands, HaveNamesOfTheirOwnAndSummaries) {
  std::set<std::string> names;
  for (const Command& command : commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    EXPECT_GT(command.summary.size(), 10) << command.name;
  }
}

TEST(Commands, HelpWithEachOption) {
  for (const Command& command : commands()) {
    CommandLine line;
    EXPECT_THROW(line.parser().parse(command.name + " --help"), CLI::CallForHelp) << command.name;
    for (const CLI::Option* option : line.parser().get_subcommand(command.name)->get_options()) {
      const bool is_hidden = option->get_group().empty();
      EXPECT_TRUE(is_hidden || !option->get_description().empty()) << command.name << " " << option->get_name();
    }
  }
}

TEST(Commands, SayInTheHelpWhichOfThemUseSeveralRanks) {
  CommandLine line;
  for (const Command& command : commands()) {
    const bool is_named = line.parser().get_description().find("`" + command.name + "`") != std::string::npos;
    EXPECT_EQ(is_named, command.ranks == Ranks::any) << command.name;
  }
}

TEST(Commands, AreChosenByTheirNames) {
  for (const auto& [arguments, name] :
       {std::pair("run a.yaml", "run"), std::pair("export a.tt --faust b.dsp", "export"),
        std::pair("analyze a.wav", "analyze")}) {
    CommandLine line;
    line.parser().parse(std::string(arguments));
    EXPECT_EQ(line.command().name, name);
  }
}

TEST(Commands, WriteManyFilesToAnOutputFolderAndOneToAnOutput) {
  for (const char* name : {"run", "check", "listen", "modes", "map", "radiate"}) {
    EXPECT_EQ(refusal(fmt::format("{} file --output-folder results", name)), "accepted");
  }
  for (const char* name : {"play", "proxies", "timbre", "evolve", "explore", "report", "mesh"}) {
    EXPECT_EQ(refusal(fmt::format("{} file -o one", name)), "accepted");
    EXPECT_EQ(refusal(fmt::format("{} file --output one", name)), "accepted");
  }
  EXPECT_EQ(refusal("abx one.wav other.wav -o page.html"), "accepted");
}

TEST(Commands, RefuseOldNamesOfOptionsWithTheNewOnes) {
  for (const char* name : {"run", "check", "listen", "modes", "map", "radiate"}) {
    for (const char* arguments :
         {" file --output results", " --output results file", " --output=results", " --output"}) {
      EXPECT_EQ(refusal(name + std::string(arguments)), "--output was renamed: use --output-folder");
    }
  }
  EXPECT_EQ(refusal("modes deck --count 3"), "--count was renamed: use --modes");
  EXPECT_EQ(refusal("map deck --count 3"), "--count was renamed: use --modes");
  EXPECT_EQ(refusal("proxies deck --result results"), "--result was renamed: use --output-folder");
  EXPECT_EQ(refusal("tune deck --target 440 --vary a=1:2 --modes 1,2"), "--modes was renamed: use --mode-numbers");
}

TEST(Commands, TakeOneOfAFewWords) {
  for (const auto& [arguments, words] :
       {std::pair("run deck --progress", "auto,line,log"), std::pair("modes deck --mass", "lumped,consistent"),
        std::pair("map deck --radiation", "boundary_elements,kirchhoff"),
        std::pair("proxies deck --priority", "distance,loudness,order")}) {
    EXPECT_THAT(refusal(arguments + std::string(" nonsense")), HasSubstr(words));
    const std::string known = words;
    EXPECT_EQ(refusal(fmt::format("{} {}", arguments, known.substr(0, known.find(',')))), "accepted");
  }
}

TEST(Commands, AnswerPeopleOrScripts) {
  EXPECT_EQ(style_of("run deck"), Style::text);
  EXPECT_EQ(style_of("check deck"), Style::text);
  EXPECT_EQ(style_of("check deck --json"), Style::json);
  EXPECT_EQ(style_of("check deck --resolved --json"), Style::deck);
  for (const char* arguments :
       {"modes deck", "map deck", "radiate deck", "evolve tree --target sound", "analyze result", "info result",
        "identify deck --measured lines", "tune deck --target 440 --vary a=1:2"}) {
    EXPECT_EQ(style_of(arguments), Style::text) << arguments;
    EXPECT_EQ(style_of(arguments + std::string(" --json")), Style::json) << arguments;
  }
}

TEST(Choices, GoWhereTheyBelong) {
  const deck::Choices<int> numbers{{{"one", 1}, {"two", 2}}};
  int number = 2;
  std::optional<int> perhaps;
  CLI::App app;
  add_choice(app, "--number", number, numbers, "a number");
  add_choice(app, "--perhaps", perhaps, numbers, "a number or none");
  EXPECT_THAT(app.help(), AnyOf(HasSubstr("=two"), HasSubstr("[two]")));  // by CLI11's version
  app.parse("--number one");
  EXPECT_EQ(number, 1);
  EXPECT_FALSE(perhaps);
  app.parse("--perhaps two");
  EXPECT_EQ(perhaps, 2);
}

}  // namespace
}  // namespace idiophone::app
