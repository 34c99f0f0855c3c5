#include "ui/connection/connection_form.h"

#include <QComboBox>
#include <QFormLayout>
#include <QIntValidator>
#include <QLineEdit>
#include <QSerialPortInfo>

#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

using Protocol = ConnectionSettings::Protocol;
using Parity = ConnectionSettings::Parity;

constexpr int usualBauds[] = {1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
constexpr int fastestBaud = 4'000'000, longestPortName = 80;

QComboBox* choiceOf(const std::vector<std::pair<QString, int>>& entries) {
  auto* choice = new QComboBox;
  for (const auto& [text, value] : entries) choice->addItem(text, value);
  return choice;
}

void choose(QComboBox& choice, int value) {
  if (const int index = choice.findData(value); index >= 0) choice.setCurrentIndex(index);
}

}  // namespace

ConnectionForm::ConnectionForm(QWidget* parent)
    : QWidget(parent),
      m_port(new QComboBox),
      m_protocol(choiceOf({{tr("GeoCOM: Alidade asks"), static_cast<int>(Protocol::GeoCom)},
                           {tr("GSI online: the instrument sends"), static_cast<int>(Protocol::Gsi)}})),
      m_baudRate(new QComboBox),
      m_dataBits(choiceOf({{QStringLiteral("7"), 7}, {QStringLiteral("8"), 8}})),
      m_parity(choiceOf({{tr("None"), static_cast<int>(Parity::None)},
                         {tr("Even"), static_cast<int>(Parity::Even)},
                         {tr("Odd"), static_cast<int>(Parity::Odd)}})),
      m_stopBits(choiceOf({{QStringLiteral("1"), 1}, {QStringLiteral("2"), 2}})),
      m_target(choiceOf({{tr("Next expected entry"), 0}, {tr("Selected row"), 1}})) {
  m_port->setEditable(true);
  m_port->setInsertPolicy(QComboBox::NoInsert);
  m_port->lineEdit()->setPlaceholderText(tr("ttyUSB0 or a path"));
  m_port->setToolTip(tr("Port of the cable: choose it, or type a path such as /dev/pts/3"));
  m_baudRate->setEditable(true);
  m_baudRate->setInsertPolicy(QComboBox::NoInsert);
  m_baudRate->setValidator(new QIntValidator(1, fastestBaud, m_baudRate));
  for (const int baud : usualBauds) m_baudRate->addItem(QString::number(baud));
  const std::pair<QComboBox*, const char*> names[] = {
      {m_port, "connection port"},          {m_protocol, "connection protocol"},
      {m_baudRate, "connection baud rate"}, {m_dataBits, "connection data bits"},
      {m_parity, "connection parity"},      {m_stopBits, "connection stop bits"},
      {m_target, "connection target"}};
  for (const auto& [choice, name] : names) choice->setObjectName(QString::fromLatin1(name));
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addRow(tr("&Port"), m_port);
  layout->addRow(tr("P&rotocol"), m_protocol);
  layout->addRow(tr("&Baud rate"), m_baudRate);
  layout->addRow(tr("&Data bits"), m_dataBits);
  layout->addRow(tr("P&arity"), m_parity);
  layout->addRow(tr("S&top bits"), m_stopBits);
  layout->addRow(tr("Readings &go to"), m_target);
  refreshPorts();
  setSettings(rememberedConnection());
  connect(m_protocol, &QComboBox::activated, this, [this] {
    ConnectionSettings settings =
        rememberedConnection(static_cast<Protocol>(m_protocol->currentData().toInt()));
    settings.port = m_port->currentText().trimmed();
    settings.intoSelected = m_target->currentData().toInt() == 1;
    showSettings(settings);
  });
  connect(m_target, &QComboBox::activated, this, &ConnectionForm::targetChanged);
}

void ConnectionForm::refreshPorts() {
  const QString typed = m_port->currentText();
  m_port->clear();
  for (const QSerialPortInfo& info : QSerialPortInfo::availablePorts()) {
    m_port->addItem(info.portName());
    const QString tip = QStringList{info.description(), info.manufacturer()}.join(u' ').trimmed();
    m_port->setItemData(m_port->count() - 1, tipText(tip), Qt::ToolTipRole);
  }
  if (!typed.isEmpty() || m_port->count() == 0) m_port->setEditText(typed);
}

ConnectionSettings ConnectionForm::settings() const {
  ConnectionSettings settings;
  settings.protocol = static_cast<Protocol>(m_protocol->currentData().toInt());
  settings.port = m_port->currentText().trimmed();
  settings.baudRate = m_baudRate->currentText().toInt();
  settings.dataBits = m_dataBits->currentData().toInt();
  settings.parity = static_cast<Parity>(m_parity->currentData().toInt());
  settings.stopBits = m_stopBits->currentData().toInt();
  settings.intoSelected = m_target->currentData().toInt() == 1;
  return settings;
}

void ConnectionForm::setSettings(const ConnectionSettings& settings) {
  choose(*m_protocol, static_cast<int>(settings.protocol));
  if (!settings.port.isEmpty()) m_port->setEditText(visibleLine(settings.port).left(longestPortName));
  showSettings(settings);
}

void ConnectionForm::showSettings(const ConnectionSettings& settings) {
  m_baudRate->setCurrentText(QString::number(settings.baudRate));
  choose(*m_dataBits, settings.dataBits);
  choose(*m_parity, static_cast<int>(settings.parity));
  choose(*m_stopBits, settings.stopBits);
  choose(*m_target, settings.intoSelected ? 1 : 0);
}

void ConnectionForm::setOpen(bool isOpen) {
  for (QComboBox* choice : {m_port, m_protocol, m_baudRate, m_dataBits, m_parity, m_stopBits})
    choice->setEnabled(!isOpen);
}

}  // namespace alidade::ui
