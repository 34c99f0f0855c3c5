#include "app/console/commands/import_command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/console/channels.h"
#include "app/console/commands/option_checks.h"
#include "app/console/output_file.h"
#include "core/base/file_bytes.h"
#include "core/base/file_target.h"
#include "core/base/list_text.h"
#include "core/base/visible_text.h"
#include "core/exchange/import.h"
#include "core/session/measurement.h"
#include "core/session/row_fields.h"
#include "core/session/session_file.h"

namespace alidade::console {

namespace {

constexpr const char* aboutGsi =
    "How a GSI file tells more than angles: code block 0 or 180 (or AXIS0, AXIS180) names the position of "
    "the\n"
    "axis for what follows, ROUND2 the round; point 0 or ZERO, or what follows code block ZERO, is the "
    "pointing\n"
    "zero. A CSV table begins with the names of its columns:\n";

constexpr const char* aboutCsv =
    "horizontal and vertical are needed, point ZERO is the pointing zero. A unit in a name, such as Hz "
    "[gon],\n"
    "holds for the plain numbers below it. What the session then still lacks is told on stderr and can be\n"
    "typed in the window.";

std::string about() {
  std::string columns = "axis";
  for (const RowField& field : rowFields) columns += ", " + std::string(field.key);
  return aboutGsi + columns + ";\n" + aboutCsv;
}

/// The entry of an option in the field of the session it is for.
std::optional<Problem> setNumber(const char* option, const char* field, const std::string& given,
                                 std::string& text) {
  if (given.empty()) return std::nullopt;
  if (const auto value = numberEntry(field, given); !value)
    return Problem{std::string(option) + ": " + value.problem().what};
  text = given;
  return std::nullopt;
}

std::optional<Problem> checkZero(const char* option, const PointingZero& zero, VerticalCircle circle) {
  for (const auto& [rule, text] :
       {std::pair(horizontalRule, zero.horizontal), std::pair(verticalRule, zero.vertical)})
    if (const auto angle = angleEntry(rule, text, circle); !angle)
      return Problem{std::string(option) + ": " + angle.problem().what};
  return std::nullopt;
}

/// What kind the circle is, a column's name may tell as well: here the wider range holds.
std::optional<Problem> setZero(const char* option, const std::vector<std::string>& given, AngleUnit unit,
                               PointingZero& zero) {
  if (given.empty()) return std::nullopt;
  zero.horizontal = withUnit(given.at(0), unit);
  zero.vertical = withUnit(given.at(1), unit);
  return checkZero(option, zero, VerticalCircle::Elevation);
}

/// The zeros that were given, in the range of the circle that the session came to have.
std::optional<Problem> checkZeros(const ImportRequest& request, const ImportOptions& options,
                                  const Session& session) {
  const auto circle = verticalCircleEntry(session.geometry.verticalCircle);
  if (!circle) return std::nullopt;
  const std::vector<Position>& positions = options.base.positions;
  std::optional<Problem> problem;
  if (!request.zero0.empty()) problem = checkZero("--zero-0", positions.at(0).zero, *circle);
  if (!problem && !request.zero180.empty()) problem = checkZero("--zero-180", positions.at(1).zero, *circle);
  return problem;
}

AngleUnit unitOf(const std::string& name) {
  if (name == "gon") return AngleUnit::Gon;
  if (name == "deg") return AngleUnit::Degrees;
  return name == "dms" ? AngleUnit::Dms : AngleUnit::Unstated;
}

Result<std::string> readBytes(const std::string& file) {
  return file == "-" ? readStandardInput() : readFile(file);
}

Result<Import> importFrom(const std::string& file, const ImportOptions& options) {
  const Result<std::string> bytes = readBytes(file);
  if (!bytes) return bytes.problem();
  return importReadings(*bytes, options);
}

std::string listOf(const Session& session) {
  std::string list;
  for (const Position& position : session.positions)
    list += (list.empty() ? "" : ", ") + std::to_string(position.readings.size()) + " at " +
            position.axisDeg + "°";
  return list;
}

}  // namespace

void addImportCommand(CLI::App& app, ImportRequest& request) {
  CLI::App* import = app.add_subcommand(
      "import", "A session from a file of readings: Leica GSI-8, GSI-16, or a table (CSV).");
  import->add_option("FILE", request.file, "File to read; - reads standard input")->required();
  import->add_option("--out", request.out, "Session file to write (*.alidade)")->required();
  import->add_option("--title", request.title, "Title of the session; else the file's name")
      ->check(textCheck());
  import->add_option("--distance", request.distance, "Theodolite to arc plane, mm");
  import->add_option("--sigma-distance", request.sigmaDistance, "Its σ, mm");
  import->add_option("--radius", request.radius, "Nominal radius of the arc, mm");
  import->add_option("--tolerance", request.tolerance, "Of the intersection, mm");
  import->add_option("--sigma", request.sigma, "σ of both circles and of the zeros, arcsec; else 2");
  import->add_option("--zero-0", request.zero0, "Pointing zero at 0°: horizontal and vertical reading")
      ->expected(2)
      ->type_name("H V");
  import->add_option("--zero-180", request.zero180, "Pointing zero at 180°")->expected(2)->type_name("H V");
  import->add_option("--zero-point", request.zeroPoint, "Name of the point that is the pointing zero");
  import
      ->add_option("--turned-at", request.turnedAtLine,
                   "Line from which on the axis stood at 180°, where the file does not say")
      ->check(wholeFrom(1, 1'000'000'000));
  import
      ->add_option("--unit", request.unit,
                   "Unit of plain numbers in a table: deg, gon, or dms (341.5224 is 341°52'24\")")
      ->check(CLI::IsMember({"deg", "gon", "dms"}));
  import->add_option("--vertical-circle", request.verticalCircle, "zenith or elevation; else zenith")
      ->check(CLI::IsMember({"zenith", "elevation"}));
  import->footer(about());
}

Result<ImportOptions> importOptions(const ImportRequest& request) {
  if (isSameFile(request.file, request.out))
    return Problem{"--out names the file that is read: give the session a file of its own"};
  ImportOptions options;
  options.unit = unitOf(request.unit);
  options.zeroPoint = request.zeroPoint;
  if (request.turnedAtLine > 0) options.turnedAtLine = request.turnedAtLine;
  Session& base = options.base;
  base.title = request.title;
  if (!request.verticalCircle.empty()) base.geometry.verticalCircle = request.verticalCircle;
  Geometry& geometry = base.geometry;
  Instrument& instrument = base.instrument;
  for (const auto& problem : {
           setNumber("--distance", "geometry.distance_mm", request.distance, geometry.distanceMm),
           setNumber("--sigma-distance", "geometry.sigma_distance_mm", request.sigmaDistance,
                     geometry.sigmaDistanceMm),
           setNumber("--radius", "geometry.radius_mm", request.radius, geometry.radiusMm),
           setNumber("--tolerance", "acceptance.tolerance_mm", request.tolerance,
                     base.acceptance.toleranceMm),
           setNumber("--sigma", "instrument.sigma_horizontal_arcsec", request.sigma,
                     instrument.sigmaHorizontalArcsec),
           setNumber("--sigma", "instrument.sigma_vertical_arcsec", request.sigma,
                     instrument.sigmaVerticalArcsec),
           setNumber("--sigma", "instrument.sigma_zero_arcsec", request.sigma, instrument.sigmaZeroArcsec),
           setZero("--zero-0", request.zero0, options.unit, base.positions.at(0).zero),
           setZero("--zero-180", request.zero180, options.unit, base.positions.at(1).zero),
       })
    if (problem) return *problem;
  return options;
}

Result<ImportAnswer> runImport(const ImportRequest& request, const ImportOptions& options) {
  Result<Import> import = importFrom(request.file, options);
  if (!import) return import.problem();
  if (const auto& problems = import->problems; !problems.empty()) {
    const std::string more =
        problems.size() > 1 ? " (and " + std::to_string(problems.size() - 1) + " more)" : "";
    return Problem{problems.front().text() + more};
  }
  if (auto problem = checkZeros(request, options, import->session)) return *std::move(problem);
  Session session = import->session;
  if (session.title.empty() && request.file != "-")
    session.title = wellFormed(std::filesystem::path(request.file).stem().string());
  if (auto problem = writeOutputs({{"--out", request.out, writeSession(session)}}, request.file))
    return *std::move(problem);

  ImportAnswer answer;
  answer.result = visibleText(request.out) + ": " + counted(import->rows, "row") + " from " + import->format +
                  " (" + listOf(session) + ")\n";
  answer.remarks = import->remarks;
  for (const Problem& problem : examine(session).problems)
    answer.remarks.push_back("still to be typed or mended: " + problem.text());
  return answer;
}

}  // namespace alidade::console
