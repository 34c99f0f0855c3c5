#include "ui/panels/model/known_sizes_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/panels/model/known_sizes_table.h"
#include "ui/settings/window_font.h"

namespace alidade::ui {

KnownSizesPanel::KnownSizesPanel(SessionDocument& document, QWidget* parent)
    : QWidget(parent), m_table(new KnownSizesTable(document)), m_about(new QLabel) {
  auto* lead =
      new QLabel(tr("A size from a certificate or a check replaces the default in the uncertainty of Δd, "
                    "measured, and in the search for causes."));
  for (QLabel* label : {lead, m_about}) {
    label->setWordWrap(true);
    label->setSizePolicy(QSizePolicy::Ignored,
                         QSizePolicy::Preferred);  // prevents a long word from widening the page
  }
  layOutByFont(*this, [this] {
    m_about->setMinimumHeight(2 * fontMetrics().lineSpacing());
    m_table->setMinimumHeight(3 * fontMetrics().lineSpacing());  // scrolls on a small screen
  });
  m_about->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  m_about->setTextFormat(Qt::PlainText);
  connect(m_table, &KnownSizesTable::explanationChanged, m_about, &QLabel::setText);
  m_about->setText(m_table->currentIndex().data(Qt::ToolTipRole).toString());
  setFocusProxy(m_table);
  auto* take = new QPushButton(tr("Take from Instrument Record…"));
  take->setObjectName(QStringLiteral("take record"));
  take->setToolTip(tr("Name, serial number, σ of the circles and known sizes from a file"));
  auto* save = new QPushButton(tr("Save as Instrument Record…"));
  save->setObjectName(QStringLiteral("save record"));
  save->setToolTip(tr("Saves the session's instrument data as a file for later sessions"));
  connect(take, &QPushButton::clicked, this, &KnownSizesPanel::recordWanted);
  connect(save, &QPushButton::clicked, this, &KnownSizesPanel::saveRecordWanted);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(take);
  buttons->addWidget(save);
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  layout->addWidget(lead);
  layout->addWidget(m_table, 1);
  layout->addWidget(m_about);
  layout->addLayout(buttons);
}

void KnownSizesPanel::commitOpenEditor() {
  m_table->commitOpenEditor();
}

bool KnownSizesPanel::hasProblem() const {
  return m_table->sizes().hasProblem();
}

void KnownSizesPanel::reveal(const KnownPlace& place) {
  m_table->reveal(m_table->sizes().cellOf(place));
}

void KnownSizesPanel::reveal(const std::string& effect) {
  m_table->reveal(m_table->sizes().cellOf(effect));
}

}  // namespace alidade::ui
