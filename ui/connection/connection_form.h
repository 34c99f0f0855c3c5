#pragma once

#include <QWidget>

#include "ui/connection/connection_settings.h"

class QComboBox;

namespace alidade::ui {

/// The form for the settings of a connection. At first it shows the settings used last.
class ConnectionForm : public QWidget {
  Q_OBJECT

 public:
  explicit ConnectionForm(QWidget* parent = nullptr);

  ConnectionSettings settings() const;
  void setSettings(const ConnectionSettings& settings);
  /// Lists the ports available now.
  void refreshPorts();
  /// While `isOpen`, the user can change only which row receives the readings.
  void setOpen(bool isOpen);

 signals:
  void targetChanged();  ///< the user chose which row receives the readings

 private:
  void showSettings(const ConnectionSettings& settings);

  QComboBox *m_port, *m_protocol, *m_baudRate, *m_dataBits, *m_parity, *m_stopBits, *m_target;
};

}  // namespace alidade::ui
