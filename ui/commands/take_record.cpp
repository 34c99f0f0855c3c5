#include "ui/commands/take_record.h"

#include <QCoreApplication>
#include <utility>

#include "core/session/taken_record.h"
#include "ui/document/session_document.h"

namespace alidade::ui {

namespace {

Place recordPlace() {
  return {.field = "instrument.record"};
}

/// `T-1, 4711, σ 2/2/1 arcsec, record t-1.alidade-instrument of 2026-03-01, 3 known sizes`.
std::string said(const Instrument& instrument) {
  std::string text = instrument.name + ", " + instrument.serial + ", σ " + instrument.sigmaHorizontalArcsec +
                     "/" + instrument.sigmaVerticalArcsec + "/" + instrument.sigmaZeroArcsec + " arcsec";
  if (!instrument.lineOfSight.offsetMm.empty())
    text += ", line of sight off by " + instrument.lineOfSight.offsetMm + " mm";
  if (!instrument.record.file.empty()) text += ", " + citationOf(instrument.record);
  return text + ", " + std::to_string(instrument.known.size()) + " known sizes";
}

}  // namespace

ChangeInstrument::ChangeInstrument(SessionDocument& document, Instrument instrument, const QString& text)
    : JournalledCommand(document, text),
      m_before(document.session().instrument),
      m_after(std::move(instrument)) {
  setEntries(journal().judge(recordPlace(), said(m_before), said(m_after)));
}

void ChangeInstrument::apply() {
  document().putInstrument(m_after);
}
void ChangeInstrument::revert() {
  document().putInstrument(m_before);
}

std::vector<JournalEntry> ChangeInstrument::allEntries() const {
  return journal().asStanding(recordPlace(), said(m_before), said(m_after));
}

std::optional<Problem> takeRecord(SessionDocument& document, const InstrumentRecord& record,
                                  const std::string& file) {
  Session alone;
  alone.instrument = document.session().instrument;
  if (auto problem = takeRecord(alone, record, file)) return problem;
  if (alone.instrument == document.session().instrument) return std::nullopt;
  document.push(new ChangeInstrument(
      document, std::move(alone.instrument),
      QCoreApplication::translate("ChangeInstrument", "Take from the instrument record")));
  return std::nullopt;
}

}  // namespace alidade::ui
