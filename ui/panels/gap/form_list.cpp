#include "ui/panels/gap/form_list.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/wording/form_sentence.h"
#include "ui/charts/gap/form_chart.h"
#include "ui/panels/parts/figure_grid.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

FormList::FormList(QWidget* parent) : QWidget(parent), m_shrinkage(wrappedLabel()) {
  constexpr std::size_t most = 3;
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (std::size_t i = 0; i < most; ++i) {
    const Row row{wrappedLabel(), wrappedLabel(), new FormChart, new QPushButton(tr("Keep as an Effect…"))};
    row.keep->hide();
    row.keep->setToolTip(tr("Makes the form an effect of your own, for this device or instrument"));
    connect(row.keep, &QPushButton::clicked, this, [this, i] { emit keepWanted(i); });
    row.about->setForegroundRole(QPalette::PlaceholderText);
    for (QWidget* part : std::initializer_list<QWidget*>{row.sentence, row.about, row.chart})
      layout->addWidget(part);
    layout->addWidget(row.keep, 0, Qt::AlignLeft);
    m_rows.push_back(row);
  }
  layout->addWidget(m_shrinkage);
}

void FormList::setGap(const Gap& gap) {
  const std::vector<FoundForm>& forms = gap.diagnosis->forms;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const Row& row = m_rows[i];
    const bool isThere = i < forms.size();
    for (QWidget* part : std::initializer_list<QWidget*>{row.sentence, row.about, row.chart})
      part->setVisible(isThere);
    row.keep->setVisible(isThere && !forms[i].form.isFree());
    if (!isThere) continue;
    row.sentence->setText(qText(formSentence(forms[i])));
    row.about->setText(qText(cleanRangeSentence(forms[i])));
    row.about->setVisible(!row.about->text().isEmpty());
    row.chart->setForm(gap, i);
  }
  m_shrinkage->setText(forms.empty() ? QString() : qText(shrinkSentence(forms.front())));
  m_shrinkage->setVisible(!m_shrinkage->text().isEmpty());
}

}  // namespace alidade::ui
