#pragma once

#include <QWidget>

#include "ui/connection/connection_settings.h"

class QComboBox;

namespace alidade::ui {

/// The settings of a connection, to be chosen; as they were last.
class ConnectionForm : public QWidget {
  Q_OBJECT

 public:
  explicit ConnectionForm(QWidget* parent = nullptr);

  ConnectionSettings settings() const;
  void setSettings(const ConnectionSettings& settings);
  /// The ports that there are now.
  void refreshPorts();
  /// Only where readings go can be changed while a connection is open.
  void setOpen(bool isOpen);

 signals:
  void targetChanged();  ///< where readings go

 private:
  void showSettings(const ConnectionSettings& settings);

  QComboBox *m_port, *m_protocol, *m_baudRate, *m_dataBits, *m_parity, *m_stopBits, *m_target;
};

}  // namespace alidade::ui
