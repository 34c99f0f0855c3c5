#pragma once

#include <QWidget>
#include <optional>

#include "core/statement/tolerance_scale.h"

namespace alidade::ui {

/// Shows the result on the scale of its tolerance: value, U and limit on one line. Hidden without a scale.
class ToleranceBar : public QWidget {
  Q_OBJECT

 public:
  explicit ToleranceBar(QWidget* parent = nullptr);

  /// `isQuiet`: the result is provisional.
  void setScale(const std::optional<ToleranceScale>& scale, bool isQuiet);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QFont pixelFont() const;

  std::optional<ToleranceScale> m_scale;
  bool m_isQuiet = false;
};

}  // namespace alidade::ui
