#include "ui/panels/window/changed_file_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/settings/theme.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

ChangedFileBar::ChangedFileBar(QWidget* parent) : QFrame(parent), m_text(new QLabel) {
  setFrameShape(StyledPanel);
  setAccessibleName(tr("Changed file"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  auto* icon = new QLabel;
  icon->setPixmap(themeIcon(QStringLiteral("warning")).pixmap(16, 16));
  auto* compare = new QPushButton(tr("Compare…"));
  compare->setObjectName(QStringLiteral("compare with file"));
  compare->setToolTip(tr("Shows what differs, and offers to reload, to save elsewhere or to overwrite"));
  connect(compare, &QPushButton::clicked, this, &ChangedFileBar::comparisonWanted);
  auto* hide = new QPushButton(tr("Hide"));
  hide->setToolTip(tr("You are asked again before the file is overwritten"));
  connect(hide, &QPushButton::clicked, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(icon);
  layout->addWidget(m_text, 1);
  layout->addWidget(compare);
  layout->addWidget(hide);
  setVisible(false);
}

void ChangedFileBar::showFor(const QString& name) {
  m_text->setText(tr("“%1” was written by another program or window.").arg(visibleLine(name)));
  show();
}

}  // namespace alidade::ui
