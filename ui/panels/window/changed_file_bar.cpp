#include "ui/panels/window/changed_file_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/settings/theme.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

ChangedFileBar::ChangedFileBar(QWidget* parent)
    : QFrame(parent),
      m_text(new QLabel),
      m_compare(new QPushButton(tr("Compare…"))),
      m_save(new QPushButton(tr("Save"))),
      m_hide(new QPushButton(tr("Hide"))) {
  setFrameShape(StyledPanel);
  setAccessibleName(tr("Changed file"));
  m_text->setTextFormat(Qt::PlainText);
  m_text->setWordWrap(true);
  auto* icon = new QLabel;
  icon->setPixmap(themeIcon(QStringLiteral("warning")).pixmap(16, 16));
  m_compare->setObjectName(QStringLiteral("compare with file"));
  m_compare->setToolTip(tr("Shows what differs, and offers to reload, to save elsewhere or to overwrite"));
  connect(m_compare, &QPushButton::clicked, this, &ChangedFileBar::comparisonWanted);
  m_save->setObjectName(QStringLiteral("save missing file"));
  m_save->setToolTip(tr("Writes the session into its file again"));
  connect(m_save, &QPushButton::clicked, this, &ChangedFileBar::saveWanted);
  connect(m_hide, &QPushButton::clicked, this, &QWidget::hide);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addWidget(icon);
  layout->addWidget(m_text, 1);
  for (QPushButton* button : {m_compare, m_save, m_hide}) layout->addWidget(button);
  setVisible(false);
}

void ChangedFileBar::showChanged(const QString& name) {
  m_hide->setToolTip(tr("You are asked again before the file is overwritten"));
  showText(tr("“%1” was written by another program or window.").arg(visibleLine(name)), false);
}

void ChangedFileBar::showMissing(const QString& name) {
  m_hide->setToolTip(tr("You are asked again before the session is closed"));
  showText(
      tr("The file “%1” was deleted, moved or renamed: only this window has the session until you save it.")
          .arg(visibleLine(name)),
      true);
}

void ChangedFileBar::showText(const QString& text, bool isMissing) {
  m_text->setText(text);
  m_compare->setVisible(!isMissing);
  m_save->setVisible(isMissing);
  show();
}

}  // namespace alidade::ui
