#include "ui/import/import_choice.h"

#include <QRegularExpression>
#include <utility>

namespace alidade::ui {

namespace {

/// The axis angle in a file name, 0 or 180; empty if the name has neither number or both.
std::string axisInName(const QString& name) {
  static const QRegularExpression number(QStringLiteral("(?<![0-9.])(0|00|000|180)(?![0-9])"));
  std::string axis;
  for (auto found = number.globalMatch(name); found.hasNext();) {
    const std::string own = found.next().captured(1) == QStringLiteral("180") ? "180" : "0";
    if (!axis.empty() && axis != own) return {};
    axis = own;
  }
  return axis;
}

void lookThrough(ImportReading& reading) {
  for (const ImportedRows& rows : reading.import->origins) {
    const auto& readings = reading.import->session.positions[rows.position].readings;
    for (std::size_t i = rows.firstRow; i < rows.firstRow + rows.count; ++i) {
      reading.hasRounds = reading.hasRounds || !readings[i].round.empty();
      reading.hasFaces = reading.hasFaces || !readings[i].face.empty();
      reading.hasSliders = reading.hasSliders || !readings[i].slider.empty();
      reading.hasTilts =
          reading.hasTilts || !readings[i].tiltCrossArcsec.empty() || !readings[i].tiltLengthArcsec.empty();
      reading.hasCorrections = reading.hasCorrections || !readings[i].corrections.empty();
      reading.hasNotes = reading.hasNotes || !readings[i].note.empty();
    }
  }
}

}  // namespace

ImportChoice proposedChoice(const std::vector<ImportSource>& sources) {
  ImportChoice choice;
  for (const ImportSource& source : sources) {
    FileChoice file;
    const std::string axis = axisInName(source.title);
    if (source.recognised.saysAxis) {
      file.where = FileChoice::Where::ByLine;
    } else if (!axis.empty()) {
      file.where = FileChoice::Where::All;
      file.axis = axis;
    }
    choice.files.push_back(file);
    if (source.recognised.isTable())
      choice.layouts.emplace(source.recognised.signature(), source.recognised.table);
  }
  return choice;
}

std::vector<ReadingsFile> filesOf(const std::vector<ImportSource>& sources, const ImportChoice& choice) {
  std::vector<ReadingsFile> files;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const FileChoice& chosen = choice.files.at(i);
    ReadingsFile file{.name = sources[i].name.toStdString(), .bytes = *sources[i].bytes};
    file.round = chosen.round;
    if (chosen.where == FileChoice::Where::All) file.axis = chosen.axis;
    if (chosen.where == FileChoice::Where::Turned) file.turnedAtLine = chosen.turnedAtLine;
    if (const auto layout = choice.layouts.find(sources[i].recognised.signature());
        layout != choice.layouts.end())
      file.table = layout->second;
    files.push_back(std::move(file));
  }
  return files;
}

ImportReading readImport(const std::vector<ImportSource>& sources, const ImportChoice& choice,
                         const Session& base) {
  ImportOptions options;
  options.base = base;
  options.zeroPoint = choice.zeroPoint;
  Result<Import> import = importReadings(filesOf(sources, choice), options);
  if (!import) return {.import = {}, .problem = import.problem().text()};
  ImportReading reading{.import = *std::move(import)};
  reading.kinds = grouped(reading.import->problems);
  lookThrough(reading);
  return reading;
}

}  // namespace alidade::ui
