#pragma once

#include <QWidget>

#include "ui/connection/connection_settings.h"

class QComboBox;

namespace alidade::ui {

/// The settings of a connection, initially the last ones.
class ConnectionForm : public QWidget {
  Q_OBJECT

 public:
  explicit ConnectionForm(QWidget* parent = nullptr);

  ConnectionSettings settings() const;
  void setSettings(const ConnectionSettings& settings);
  /// Lists the ports available now.
  void refreshPorts();
  /// During a connection only the target of readings can be changed.
  void setOpen(bool isOpen);

 signals:
  void targetChanged();  ///< the target of readings

 private:
  void showSettings(const ConnectionSettings& settings);

  QComboBox *m_port, *m_protocol, *m_baudRate, *m_dataBits, *m_parity, *m_stopBits, *m_target;
};

}  // namespace alidade::ui
