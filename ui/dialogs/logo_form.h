#pragma once

#include <QGroupBox>

class QLabel;

namespace alidade::ui {

/// Shows the laboratory's logo as printed, and lets the user choose another.
class LogoForm : public QGroupBox {
  Q_OBJECT

 public:
  explicit LogoForm(const QString& path, QWidget* parent = nullptr);

  QString path() const { return m_path; }  ///< empty: none

 private:
  void choose();
  void setPath(const QString& path);

  QString m_path;
  QLabel *m_picture, *m_name;
  QWidget* m_without;  ///< the button that removes the logo
};

}  // namespace alidade::ui
