#pragma once

#include <QDialog>
#include <optional>

#include "core/base/angle_text.h"
#include "core/session/sighting_protocol.h"

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace alidade::ui {

class FormDraft;

/// A form for a protocol that is the same in all positions. Other protocols require a file.
class ProtocolDialog : public QDialog {
  Q_OBJECT

 public:
  /// Places are typed and shown in degrees or in gon.
  ProtocolDialog(const SightingProtocol& protocol, CircleUnit unit, QWidget* parent = nullptr);

  /// Absent if the places or the turn of the circle cannot be parsed.
  std::optional<SightingProtocol> protocol() const;

 private:
  void show(const SightingProtocol& shown);
  void keepDraft();
  void check();
  std::optional<std::vector<ProtocolPlace>> places() const;

  CircleUnit m_unit;
  std::string m_description;
  SightingMinutes m_minutes;
  QLineEdit *m_name, *m_places, *m_turn;
  QSpinBox* m_rounds;
  QComboBox *m_way, *m_faces, *m_positions;
  QCheckBox *m_slider, *m_zeroFaces, *m_zerosAfter, *m_byWorth;
  QDoubleSpinBox *m_turningAxis, *m_plungingTelescope, *m_drivingSlider;
  QLabel* m_remark;
  QDialogButtonBox* m_buttons;
  FormDraft* m_draft = nullptr;
};

}  // namespace alidade::ui
