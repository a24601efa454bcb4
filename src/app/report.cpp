// `idiophone report`: one web page about a run, or two compared.

#include "idiophone/study/report/report_page.hpp"

#include "command.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/run/loop/stop.hpp"

namespace idiophone::app {

namespace {

struct ReportOptions {
  std::vector<std::filesystem::path> results;  ///< NAME.h5, one or two
  std::filesystem::path page = "report.html";  ///< to write
};

void declare(CLI::App& app, ReportOptions& options) {
  app.add_option("results", options.results, "NAME.h5, or two to compare")->required()->expected(1, 2);
  add_output_file(app, options.page, "the page to write");
}

int report(const ReportOptions& options) {
  web::write_page(options.page.string(), report::page(options.results));
  return loop::exit_finished;
}

}  // namespace

Command report_command() {
  return make_command<ReportOptions>("report", "make one web page about a run, or about two to compare", Ranks::one,
                                     declare, report);
}

}  // namespace idiophone::app
