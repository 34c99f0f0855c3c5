#include "app/console/commands/discover_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/console/diagnosis_text.h"
#include "core/answers/json_parts.h"
#include "core/answers/json_text.h"
#include "core/base/file_bytes.h"
#include "core/base/visible_text.h"
#include "core/diagnosis/discover.h"

namespace alidade::console {

void addDiscoverCommand(CLI::App& app, DiscoverRequest& request) {
  CLI::App* discover = app.add_subcommand(
      "discover", "The form of what a table of residuals holds: harmonic, bump, step, and so on.");
  discover
      ->add_option("TABLE.csv", request.file,
                   "Columns residual_arcsec, sigma_arcsec, circle (horizontal or vertical), azimuth_deg, "
                   "elevation_deg; optional time, leg, face and base:NAME; - reads standard input")
      ->required();
  discover->add_flag("--json", request.json, "Print one JSON document");
}

Result<std::string> runDiscover(const DiscoverRequest& request) {
  const Result<std::string> bytes = request.file == "-" ? readStandardInput() : readFile(request.file);
  if (!bytes) return bytes.problem();
  const Result<Discovery> discovery = discover(*bytes);
  if (!discovery) return discovery.problem();
  const std::string name =
      request.file == "-" ? "-" : wellFormed(std::filesystem::path(request.file).filename().string());
  if (!request.json) return discoveryText(name, *discovery);
  nlohmann::ordered_json json = {{"table", name},
                                 {"readings", discovery->readings},
                                 {"rms_arcsec", discovery->rms},
                                 {"reduced_chi2", discovery->reducedChiSquare},
                                 {"noise_scale", discovery->noise}};
  json["forms"] = formsJson(discovery->forms);
  return answerText(std::move(json));
}

}  // namespace alidade::console
