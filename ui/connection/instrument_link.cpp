#include "ui/connection/instrument_link.h"

#include <algorithm>

#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr qint64 portBuffer = 1 << 16;      // bytes waiting to be read
constexpr qint64 mostUnsent = 1 << 12;      // bytes, about a hundred requests that were not sent
constexpr Milliseconds anyWait = 3600'000;  // longer than any protocol waits

QSerialPort::Parity parityOf(ConnectionSettings::Parity parity) {
  if (parity == ConnectionSettings::Parity::Even) return QSerialPort::EvenParity;
  return parity == ConnectionSettings::Parity::Odd ? QSerialPort::OddParity : QSerialPort::NoParity;
}

}  // namespace

InstrumentLink::InstrumentLink(QObject* parent) : QObject(parent) {
  m_clock.start();
  m_wake.setSingleShot(true);
  m_port.setReadBufferSize(portBuffer);
  connect(&m_port, &QSerialPort::readyRead, this, &InstrumentLink::receive);
  connect(&m_port, &QSerialPort::errorOccurred, this, &InstrumentLink::fail);
  connect(&m_wake, &QTimer::timeout, this, [this] {
    if (m_talk) follow(m_talk->tick(m_clock.elapsed()));
  });
}

InstrumentLink::~InstrumentLink() {
  m_port.disconnect(this);
}

bool InstrumentLink::open(const ConnectionSettings& settings, const TalkCircles& circles) {
  close();
  m_settings = settings;
  m_port.setPortName(settings.port);
  m_port.setBaudRate(settings.baudRate);
  m_port.setDataBits(settings.dataBits == 7 ? QSerialPort::Data7 : QSerialPort::Data8);
  m_port.setParity(parityOf(settings.parity));
  m_port.setStopBits(settings.stopBits == 2 ? QSerialPort::TwoStop : QSerialPort::OneStop);
  m_port.setFlowControl(QSerialPort::NoFlowControl);
  if (!m_port.open(QIODevice::ReadWrite)) {
    const bool isForbidden = m_port.error() == QSerialPort::PermissionError;
    const QString why = visibleLine(m_port.errorString()), name = visibleLine(settings.port);
    emit remark(
        isForbidden
            ? tr("The port %1 could not be opened: %2. Another program may be using it, or you are "
                 "not in the group that may use ports (on Debian: dialout).")
                  .arg(name, why)
            : tr("The port %1 could not be opened: %2. Is the cable plugged in, and is this the right port?")
                  .arg(name, why));
    return false;
  }
  emit succeeded();
  m_talk = createTalk(settings.protocol, circles);
  emit stateChanged();
  follow(m_talk->begin(m_clock.elapsed()));
  return true;
}

/// Closes the connection after reporting an incomplete message.
void InstrumentLink::close() {
  if (!m_talk) return;
  m_wake.stop();
  const bool wasTaking = m_talk->isTaking();
  const auto remarks = m_talk->tick(m_clock.elapsed() + anyWait).remarks;
  m_talk.reset();
  m_port.close();
  for (const std::string& sentence : remarks) emit remark(visibleLine(sentence));
  if (wasTaking) emit remark(tr("The connection was closed before the reading came: none was taken."));
  emit stateChanged();
}

void InstrumentLink::take() {
  if (!m_talk) return emit remark(tr("No instrument is connected: connect it first (Instrument › Connect)."));
  follow(m_talk->take(m_clock.elapsed()));
}

void InstrumentLink::setCircles(const TalkCircles& circles) {
  if (m_talk) m_talk->setCircles(circles);
}

void InstrumentLink::receive() {
  const QByteArray bytes = m_port.readAll();
  if (m_talk)
    follow(m_talk->receive({bytes.constData(), static_cast<std::size_t>(bytes.size())}, m_clock.elapsed()));
}

/// Reports a port error, usually caused by unplugging, and closes the connection.
void InstrumentLink::fail(QSerialPort::SerialPortError error) {
  if (!m_talk || error == QSerialPort::NoError || error == QSerialPort::TimeoutError) return;
  emit remark(tr("The connection to the instrument broke: %1. Was the cable or the instrument unplugged? The "
                 "readings are kept; plug it in and connect again.")
                  .arg(visibleLine(m_port.errorString())));
  close();
}

void InstrumentLink::follow(const TalkStep& step) {
  for (const TalkLine& one : step.lines) emit line(one.isSent, qText(shownLine(one.text)));
  send(step.toSend);
  if (step.isIdentified || !step.readings.empty()) emit succeeded();
  for (const std::string& sentence : step.remarks) emit remark(visibleLine(sentence));
  for (const InstrumentReading& reading : step.readings) emit readingTaken(reading);
  if (!m_talk) return;  // a slot or a port error has closed the connection
  if (step.isIdentified) emit identified();
  if (const auto at = m_talk->wakeAt())
    m_wake.start(static_cast<int>(std::clamp<Milliseconds>(*at - m_clock.elapsed(), 0, anyWait)));
  else
    m_wake.stop();
  emit stateChanged();
}

void InstrumentLink::send(const std::string& bytes) {
  if (bytes.empty()) return;
  const auto size = static_cast<qint64>(bytes.size());
  if (m_port.bytesToWrite() + size > mostUnsent)
    return emit remark(
        tr("The instrument accepts no data: the send buffer is full, and sending has stopped. Check the "
           "cable and the instrument, then connect again."));
  m_port.write(bytes.data(), size);
}

}  // namespace alidade::ui
