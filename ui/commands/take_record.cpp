#include "ui/commands/change_session.h"

#include <QCoreApplication>

#include "core/session/taken_record.h"
#include "ui/commands/change_part.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

/// For the journal: `T-1, 4711, σ 2/2/1 arcsec, record t-1.alidade-instrument of 2026-03-01, 3 known sizes`.
std::string said(const Instrument& instrument) {
  std::string text = instrument.name + ", " + instrument.serial + ", σ " + instrument.sigmaHorizontalArcsec +
                     "/" + instrument.sigmaVerticalArcsec + "/" + instrument.sigmaZeroArcsec + " arcsec";
  if (!instrument.lineOfSight.offsetMm.empty())
    text += ", line of sight off by " + instrument.lineOfSight.offsetMm + " mm";
  if (!instrument.record.file.empty()) text += ", " + citationOf(instrument.record);
  return text + ", " + std::to_string(instrument.known.size()) + " known sizes";
}

}  // namespace

std::optional<Problem> takeRecord(SessionDocument& document, const InstrumentRecord& record,
                                  const std::string& file) {
  Session alone;
  alone.instrument = document.session().instrument;
  if (auto problem = takeRecord(alone, record, file)) return problem;
  const Instrument& before = document.session().instrument;
  if (alone.instrument == before) return std::nullopt;
  document.push(new ChangePart<Instrument>(
      document, QCoreApplication::translate("ChangeInstrument", "Take from the instrument record"),
      [](Session& session) -> Instrument& { return session.instrument; }, alone.instrument,
      {{}, {.field = "instrument.record"}, said(before), said(alone.instrument)}));
  return std::nullopt;
}

}  // namespace alidade::ui
