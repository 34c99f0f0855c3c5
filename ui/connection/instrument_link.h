#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QSerialPort>
#include <QTimer>
#include <memory>

#include "ui/connection/connection_settings.h"

namespace alidade::ui {

/// The connection to an instrument: a serial port and the protocol on it. No function blocks: replies and
/// readings arrive as signals.
class InstrumentLink : public QObject {
  Q_OBJECT

 public:
  explicit InstrumentLink(QObject* parent = nullptr);
  ~InstrumentLink() override;

  /// Closes an open connection, then opens the port. Returns false on failure; `remark` gives the reason.
  bool open(const ConnectionSettings& settings, const TalkCircles& circles);
  void close();
  /// Requests a reading of the present pointing.
  void take();
  void setCircles(const TalkCircles& circles);

  bool isOpen() const { return m_talk != nullptr; }
  bool isTaking() const { return m_talk && m_talk->isTaking(); }
  /// The identity reported by the instrument; empty before the report.
  InstrumentIdentity identity() const { return m_talk ? m_talk->identity() : InstrumentIdentity(); }
  const ConnectionSettings& settings() const { return m_settings; }

 signals:
  void stateChanged();  ///< after opening, closing and every step of the protocol
  void identified();
  void succeeded();  ///< the port was opened, or an identity or reading arrived; ends earlier failures
  void readingTaken(const alidade::InstrumentReading& reading);
  void remark(const QString& sentence);
  void line(bool isSent, const QString& shown);  ///< `shown`: the line with escaped invisible characters

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
