#include "idiophone/foundation/deck/csv.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace idiophone::deck {
namespace {

using ::testing::ElementsAre;

/// What a program writes to a named pipe that is read as a table, such as <(command) of a shell.
class PipedTable : public testing::Test {
 protected:
  PipedTable() : pipe_(testing::TempDir() + "idiophone_csv_" + std::to_string(::getpid())) {
    std::filesystem::remove(pipe_);
    EXPECT_EQ(::mkfifo(pipe_.c_str(), 0600), 0);
  }
  ~PipedTable() override { std::filesystem::remove(pipe_); }
  PipedTable(const PipedTable&) = delete;
  PipedTable& operator=(const PipedTable&) = delete;
  PipedTable(PipedTable&&) = delete;
  PipedTable& operator=(PipedTable&&) = delete;

  [[nodiscard]] std::vector<CsvRow> rows(const std::string& text, std::optional<CsvHeader>* header = nullptr) const {
    const std::jthread writer([&] { std::ofstream(pipe_) << text; });
    Mistakes mistakes;
    std::vector<CsvRow> found;
    EXPECT_TRUE(read_csv(pipe_, {{.name = "time"}, {.name = "value"}}, mistakes, found, header));
    return found;
  }

 private:
  std::filesystem::path pipe_;
};

TEST_F(PipedTable, IsReadFromItsFirstByte) {
  const std::vector<CsvRow> found = rows("0, 7\n1, 8\n");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].values, ElementsAre(0, 7));
  EXPECT_THAT(found[1].values, ElementsAre(1, 8));
}

TEST_F(PipedTable, CanBeginWithAByteOrderMark) {
  std::optional<CsvHeader> header;
  EXPECT_EQ(rows("\xEF\xBB\xBFtime/s, force/N\n0, 7\n", &header).size(), 1U);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->text, "time/s, force/N");
}

}  // namespace
}  // namespace idiophone::deck
