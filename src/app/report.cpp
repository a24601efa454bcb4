#include "idiophone/study/report/report_page.hpp"

#include "commands.hpp"
#include "idiophone/foundation/web/page_file.hpp"
#include "idiophone/run/loop/stop.hpp"

namespace idiophone::app {

int report(const ReportOptions& options) {
  web::write_page(options.page, report::page(options.results));
  return loop::exit_finished;
}

}  // namespace idiophone::app
