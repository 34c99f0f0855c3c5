#include "ui/connection/connection_dialog.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/connection/connection_form.h"
#include "ui/connection/instrument_link.h"
#include "ui/connection/wire_log.h"
#include "ui/dialogs/dialogs.h"
#include "ui/dialogs/written_file.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct ConnectionText {
  Q_DECLARE_TR_FUNCTIONS(ConnectionText)
};

constexpr int longestName = 60;

}  // namespace

QString connectionText(const InstrumentLink& link) {
  if (!link.isOpen()) return ConnectionText::tr("No instrument connected");
  const InstrumentIdentity identity = link.identity();
  const QString port = shortLine(link.settings().port, longestName);
  QString who = identity.name.empty() ? port : shortLine(identity.name, longestName);
  if (!identity.serial.empty())
    who = ConnectionText::tr("%1, serial number %2").arg(who, shortLine(identity.serial, longestName));
  if (link.isTaking()) return ConnectionText::tr("%1: reading…").arg(who);
  const bool isSilent =
      identity.name.empty() && link.settings().protocol == ConnectionSettings::Protocol::GeoCom;
  return isSilent ? ConnectionText::tr("%1: open").arg(who) : ConnectionText::tr("%1: connected").arg(who);
}

ConnectionDialog::ConnectionDialog(InstrumentLink& link, Dialogs& dialogs, QWidget* parent)
    : QDialog(parent),
      m_link(link),
      m_dialogs(dialogs),
      m_form(new ConnectionForm),
      m_log(new WireLog),
      m_status(createPlainLabel({})),
      m_said(createPlainLabel({})) {
  setWindowTitle(tr("Instrument Connection"));
  m_status->setObjectName(QStringLiteral("connection status"));
  m_said->setObjectName(QStringLiteral("connection remark"));
  auto* entries = new QVBoxLayout;
  entries->addWidget(m_form);
  entries->addWidget(m_status);
  entries->addWidget(m_said);
  entries->addStretch();
  auto* parts = new QHBoxLayout;
  parts->addLayout(entries);
  parts->addWidget(m_log, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(parts, 1);
  layout->addWidget(createButtons());
  m_form->setFixedWidth(m_form->sizeHint().width());
  m_status->setFixedWidth(m_form->width());
  m_said->setFixedWidth(m_form->width());
  resize(880, 460);
  connect(&m_link, &InstrumentLink::stateChanged, this, &ConnectionDialog::showState);
  connect(&m_link, &InstrumentLink::line, m_log, &WireLog::addLine);
  showState();
}

QWidget* ConnectionDialog::createButtons() {
  auto* row = new ButtonRow;
  m_connect = row->add(tr("&Connect"), "connect instrument");
  m_take = row->add(tr("Ta&ke Reading"), "take reading");
  row->addRoom();
  m_save = row->add(tr("&Save Log…"), "save connection log");
  auto* close = row->add(tr("Close"), "close connection dialog");
  close->setToolTip(tr("The connection stays open"));
  connect(m_connect, &QPushButton::clicked, this, &ConnectionDialog::connectWanted);
  connect(m_take, &QPushButton::clicked, this, &ConnectionDialog::takeWanted);
  connect(m_save, &QPushButton::clicked, this, &ConnectionDialog::saveLog);
  connect(close, &QPushButton::clicked, this, &QDialog::close);
  return row;
}

void ConnectionDialog::showRemark(const QString& sentence) {
  m_said->setText(sentence);
  m_log->addRemark(sentence);
}

void ConnectionDialog::clearRemark() {
  m_said->clear();
}

void ConnectionDialog::showState() {
  m_status->setText(connectionText(m_link));
  m_form->setOpen(m_link.isOpen());
  m_connect->setText(m_link.isOpen() ? tr("Dis&connect") : tr("&Connect"));
  m_take->setEnabled(m_link.isOpen() && !m_link.isTaking());
}

void ConnectionDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  if (!m_link.isOpen()) m_form->refreshPorts();
}

bool ConnectionDialog::saveLog() {
  const QString stamp = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd-HHmm"));
  const QString suggestion = QDir::home().filePath(QStringLiteral("instrument-%1.log").arg(stamp));
  return writeToChosenPath(m_dialogs, tr("Save log of the connection"), suggestion, QStringLiteral("log"),
                           m_log->bytes())
      .has_value();
}

}  // namespace alidade::ui
