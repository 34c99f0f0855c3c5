#include "ui/connection/instrument_desk.h"

#include <QLabel>
#include <algorithm>
#include <utility>

#include "core/base/visible_text.h"
#include "core/session/entry.h"
#include "ui/commands/change_session.h"
#include "ui/connection/connection_dialog.h"
#include "ui/connection/connection_form.h"
#include "ui/connection/reading_question_bar.h"
#include "ui/document/session_document.h"
#include "ui/jobs/fit_job.h"
#include "ui/panels/readings/position_tabs.h"
#include "ui/panels/readings/readings_table.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestShown = 60;

}  // namespace

InstrumentDesk::InstrumentDesk(SessionDocument& document, Dialogs& dialogs, const FitJob& job,
                               QWidget& window)
    : QObject(&window),
      m_document(document),
      m_dialogs(dialogs),
      m_window(window),
      m_flow(document),
      m_bar(new ReadingQuestionBar(m_flow)),
      m_status(new QLabel) {
  m_status->setTextFormat(Qt::PlainText);
  m_status->setObjectName(QStringLiteral("instrument status"));
  m_status->hide();
  m_flow.setFront([this] { return front(); });
  connect(&m_flow, &ReadingFlow::heldChanged, this, &InstrumentDesk::showState);
  connect(&m_flow, &ReadingFlow::remark, this, &InstrumentDesk::report);
  connect(&m_flow, &ReadingFlow::landed, this, &InstrumentDesk::goOn);
  connect(&m_link, &InstrumentLink::readingTaken, this, &InstrumentDesk::accept);
  connect(&m_link, &InstrumentLink::remark, this, &InstrumentDesk::report);
  connect(&m_link, &InstrumentLink::succeeded, this, &InstrumentDesk::forgetRemark);
  connect(&m_link, &InstrumentLink::identified, this, &InstrumentDesk::noteIdentity);
  connect(&m_link, &InstrumentLink::stateChanged, this, &InstrumentDesk::showState);
  connect(&document, &SessionDocument::changed, this, [this] { m_link.setCircles(circles()); });
  // Queued, so that all views receive the evaluation first. During a new fit the evaluation is outdated.
  connect(
      &job, &FitJob::evaluated, this,
      [this, &job](const SharedEvaluation& evaluation) {
        if (!job.isFitting()) m_flow.setEvaluation(evaluation);
      },
      Qt::QueuedConnection);
}

void InstrumentDesk::setPositions(PositionTabs& positions) {
  m_positions = &positions;
}

void InstrumentDesk::setHeld(bool isHeld) {
  m_isHeld = isHeld;
  m_flow.setHeld(isHeld);
  if (!isHeld && std::exchange(m_isIdentityDue, false)) noteIdentity();
}

TalkCircles InstrumentDesk::circles() const {
  const auto kind = verticalCircleEntry(m_document.session().geometry.verticalCircle);
  return {kind ? *kind : VerticalCircle::Zenith, circleUnitOf(m_document.session())};
}

ReadingFlow::Front InstrumentDesk::front() const {
  if (!m_positions) return {};
  ReadingFlow::Front front{static_cast<std::size_t>(std::max(0, m_positions->currentIndex())), {}};
  const ReadingsTable* table = m_positions->currentTable();
  const bool isSelected = m_dialog && m_dialog->form().settings().intoSelected;
  if (isSelected && table && table->currentIndex().isValid())
    front.selected = static_cast<std::size_t>(table->currentIndex().row());
  return front;
}

/// Reports where a reading was stored, or the next row if readings go into the selected row.
void InstrumentDesk::goOn(const Place& place) {
  const bool isSelected = m_dialog && m_dialog->form().settings().intoSelected;
  Place shown = place;
  if (isSelected && shown.reading) ++*shown.reading;
  emit landed(shown);
}

ConnectionDialog& InstrumentDesk::dialog() {
  if (m_dialog) return *m_dialog;
  m_dialog = new ConnectionDialog(m_link, m_dialogs, &m_window);
  connect(m_dialog, &ConnectionDialog::connectWanted, this, &InstrumentDesk::toggle);
  connect(m_dialog, &ConnectionDialog::takeWanted, this, &InstrumentDesk::take);
  return *m_dialog;
}

void InstrumentDesk::showDialog() {
  dialog().show();
  dialog().raise();
  dialog().activateWindow();
}

void InstrumentDesk::toggle() {
  if (m_link.isOpen()) return m_link.close();
  const ConnectionSettings settings = dialog().form().settings();
  if (settings.port.isEmpty()) return report(tr("No port is chosen: choose the one that the cable is in."));
  if (settings.baudRate <= 0) return report(tr("No baud rate is chosen: choose that of the instrument."));
  rememberConnection(settings);
  m_link.open(settings, circles());
}

void InstrumentDesk::take() {
  if (!m_link.isOpen()) showDialog();
  m_takingFor = m_document.sessionNumber();
  m_link.take();
}

/// Passes on a reading, unless its session was left since it was requested.
void InstrumentDesk::accept(const InstrumentReading& reading) {
  if (m_takingFor.value_or(m_document.sessionNumber()) == m_document.sessionNumber())
    return m_flow.add(reading);
  report(tr("The reading that came now was requested for another session and was not taken in: read again."));
}

/// Names the instrument in a session that names none; otherwise compares the serial numbers.
void InstrumentDesk::noteIdentity() {
  if (m_isHeld) {
    m_isIdentityDue = true;
    return;
  }
  const InstrumentIdentity identity = m_link.identity();
  const Instrument& stated = m_document.session().instrument;
  const bool isNew = stated.name.empty() && stated.serial.empty();
  if (isNew && !identity.serial.empty()) {
    m_document.beginTogether(tr("Name the instrument"));
    changeField(m_document, {.field = "instrument.name"}, wellFormed(identity.name));
    changeField(m_document, {.field = "instrument.serial"}, wellFormed(identity.serial));
    m_document.endTogether();
  } else if (!identity.serial.empty() && !stated.serial.empty() && identity.serial != stated.serial) {
    report(tr("The session names an instrument with serial number %1, but the connected one has %2.")
               .arg(shortLine(stated.serial, longestShown), shortLine(identity.serial, longestShown)));
  }
}

void InstrumentDesk::report(const QString& sentence) {
  dialog().showRemark(sentence);
  m_hasRemark = true;
  emit remark(sentence);
}

/// Clears the failure shown in the dialog and in the status bar.
void InstrumentDesk::forgetRemark() {
  if (!std::exchange(m_hasRemark, false)) return;
  dialog().clearRemark();
  emit remark({});
}

/// Updates the status text, which is visible from the first connection on.
void InstrumentDesk::showState() {
  if (!m_link.isTaking()) m_takingFor.reset();
  m_status->setText(m_flow.isHeldByEntry()
                        ? tr("%1 readings wait until the open entry is accepted (Enter) or cancelled (Esc)")
                              .arg(m_flow.waiting())
                        : connectionText(m_link));
  if (m_link.isOpen()) m_status->show();
}

}  // namespace alidade::ui
