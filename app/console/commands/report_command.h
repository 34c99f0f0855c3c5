#pragma once

#include <string>
#include <vector>

#include "app/console/batch.h"
#include "core/signature/signature.h"

namespace CLI {
class App;
}

namespace alidade::console {

/// The arguments of `alidade-cli report`.
struct ReportRequest {
  std::vector<std::string> files;
  std::string into = {};      ///< folder of the reports; empty: each beside its session
  std::string language = {};  ///< empty: as `alidade` chooses it
  SigningFiles signing = {};
  BatchOptions batch = {};
};

/// Adds `report FILE… [--into FOLDER] [--language ID] [signing] [--threads N] [--progress] [--json]`, which
/// fills in `request`.
void addReportCommand(CLI::App& app, ReportRequest& request);

/// Writes the acceptance report of each session, named like the session with the suffix `.pdf`. The program
/// `alidade` in the folder of this program makes the reports, one process for each session, without a
/// display. If several sessions would have the same report path, only the first one gets a report.
int giveReports(const ReportRequest& request);

}  // namespace alidade::console
