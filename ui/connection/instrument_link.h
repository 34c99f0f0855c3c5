#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSerialPort>
#include <QTimer>
#include <memory>

#include "ui/connection/connection_settings.h"

namespace alidade::ui {

/// The line to an instrument: a serial port, and on it the talk of its protocol. Waits for nothing: all comes
/// as signals.
class InstrumentLink : public QObject {
  Q_OBJECT

 public:
  explicit InstrumentLink(QObject* parent = nullptr);
  ~InstrumentLink() override;

  /// False: the port could not be opened, and `remark` says why. Closes what was open.
  bool open(const ConnectionSettings& settings, const TalkCircles& circles);
  void close();
  /// Asks for a reading of what the telescope points at.
  void take();
  void setCircles(const TalkCircles& circles);

  bool isOpen() const { return m_talk != nullptr; }
  bool isTaking() const { return m_talk && m_talk->isTaking(); }
  /// Of the instrument at the other end, as far as it said; empty before.
  InstrumentIdentity identity() const { return m_talk ? m_talk->identity() : InstrumentIdentity(); }
  const ConnectionSettings& settings() const { return m_settings; }

 signals:
  void stateChanged();  ///< opened, closed, taking or not, identified
  void identified();
  void succeeded();  ///< the port was opened, an answer or a reading came: what failed before is over
  void readingTaken(const alidade::InstrumentReading& reading);
  void remark(const QString& sentence);
  void line(bool isSent, const QString& shown);  ///< as it went over the wire, all visible

 private:
  void receive();
  void fail(QSerialPort::SerialPortError error);
  void follow(const TalkStep& step);
  void send(const std::string& bytes);

  QSerialPort m_port;
  QTimer m_wake;
  QElapsedTimer m_clock;
  ConnectionSettings m_settings;
  std::unique_ptr<InstrumentTalk> m_talk;  ///< null: not open
};

}  // namespace alidade::ui
