#include "idiophone/report/page.hpp"

#include "commands.hpp"
#include "page_file.hpp"
#include "stop.hpp"

namespace idiophone::app {

int report(const ReportOptions& options) {
  write_page(options.page, report::page(options.results));
  return exit_finished;
}

}  // namespace idiophone::app
