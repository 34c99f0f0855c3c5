#include "ui/dialogs/logo_form.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/panels/parts/dialog_parts.h"
#include "ui/report/report_logo.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr QSize logoSize(170, 44);  // pixels

}  // namespace

LogoForm::LogoForm(const QString& path, QWidget* parent)
    : QGroupBox(tr("Logo of the laboratory"), parent), m_picture(new QLabel), m_name(createPlainLabel({})) {
  m_picture->setMinimumSize(logoSize);
  m_picture->setAlignment(Qt::AlignCenter);
  auto* choose = new QPushButton(tr("C&hoose…"));
  choose->setAutoDefault(false);
  auto* without = new QPushButton(tr("&Without"));
  without->setAutoDefault(false);
  without->setObjectName(QStringLiteral("no logo"));
  m_without = without;
  connect(choose, &QPushButton::clicked, this, &LogoForm::choose);
  connect(without, &QPushButton::clicked, this, [this] { setPath({}); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(choose);
  buttons->addWidget(without);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_picture);
  layout->addWidget(m_name);
  layout->addLayout(buttons);
  setPath(path);
}

void LogoForm::choose() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Logo of the laboratory"), QFileInfo(m_path).absolutePath(),
      tr("Pictures (*.png *.svg *.jpg *.jpeg *.bmp *.gif *.webp);;All files (*)"));
  if (!path.isEmpty()) setPath(path);
}

/// Shows the logo on white, as it is printed.
void LogoForm::setPath(const QString& path) {
  m_path = path;
  m_without->setEnabled(!path.isEmpty());
  m_picture->clear();
  m_picture->setStyleSheet({});
  if (path.isEmpty()) {
    m_name->setText(tr("None"));
    return;
  }
  const Result<QImage> logo = readLogo(path);
  m_name->setText(logo ? shortLine(QFileInfo(path).fileName(), 40) : visibleLine(logo.problem().what) + u'.');
  if (!logo) return;
  m_picture->setStyleSheet(QStringLiteral("background: white;"));
  m_picture->setPixmap(
      QPixmap::fromImage(logo->scaled(logoSize, Qt::KeepAspectRatio, Qt::SmoothTransformation)));
}

}  // namespace alidade::ui
