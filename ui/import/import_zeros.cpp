#include "ui/import/import_zeros.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <set>

#include "core/session/entry.h"
#include "core/session/row_fields.h"
#include "ui/recovery/form_draft.h"
#include "ui/settings/theme.h"
#include "ui/text/entry_text.h"
#include "ui/text/position_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

ImportZeros::ImportZeros(FormDraft& draft) : m_draft(draft), m_grid(new QGridLayout(this)) {
  m_grid->setContentsMargins(0, 0, 0, 0);
  m_grid->setColumnStretch(1, 1);
  m_grid->setColumnStretch(2, 1);
  m_grid->addWidget(new QLabel(tr("Horizontal")), 0, 1);
  m_grid->addWidget(new QLabel(tr("Vertical")), 0, 2);
}

ImportZeros::Row& ImportZeros::rowOf(const QString& name) {
  if (const auto found = m_rows.find(name); found != m_rows.end()) return found->second;
  const int at = m_grid->rowCount();
  auto* label = new QLabel(m_rows.empty() ? tr("&Zero at %1:").arg(name) : tr("Zero at %1:").arg(name));
  const auto edit = [&](const QString& pattern, int column) {
    auto* line = new QLineEdit;
    line->setAccessibleName(pattern.arg(name));
    line->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("359°59′59.999″ ")) + 12);
    line->setObjectName(QStringLiteral("import zero %1 %2").arg(name, column == 1 ? u"h" : u"v"));
    m_grid->addWidget(line, at, column);
    connect(line, &QLineEdit::textChanged, this, [this] {
      check();
      emit typed();
    });
    m_draft.add(line->objectName(), *line);
    return line;
  };
  m_grid->addWidget(label, at, 0);
  Row row{.label = label,
          .horizontal = edit(tr("Horizontal pointing zero at %1"), 1),
          .vertical = edit(tr("Vertical pointing zero at %1"), 2),
          .position = 0,
          .isTyped = true};
  label->setBuddy(row.horizontal);
  return m_rows.emplace(name, row).first->second;
}

void ImportZeros::show(const Import* import) {
  std::set<QString> shown;
  std::set<std::size_t> positions;
  if (import) {
    const auto circle = verticalCircleEntry(import->session.geometry.verticalCircle);
    m_circle = circle ? *circle : VerticalCircle::Zenith;
    m_unit = circleUnitOf(import->session);
  }
  if (import)
    for (const ImportedRows& rows : import->origins) positions.insert(rows.position);
  for (const std::size_t position : positions) {
    const QString name = positionText(import->session, position);
    shown.insert(name);
    Row& row = rowOf(name);
    const PointingZero& zero = import->session.positions[position].zero;
    const bool isThere = !zero.horizontal.empty() || !zero.vertical.empty();
    row.position = position;
    const auto fill = [&](QLineEdit& line, const std::string& text) {
      const QSignalBlocker quiet(line);
      if (isThere || !row.isTyped) line.setText(isThere ? visibleLine(shownAngle(text, m_unit)) : QString());
      line.setReadOnly(isThere);
      line.setPlaceholderText(isThere ? QString() : tr("type it now or later"));
      line.setToolTip(isThere ? tr("As in the files or the session") : QString());
    };
    fill(*row.horizontal, zero.horizontal);
    fill(*row.vertical, zero.vertical);
    row.isTyped = !isThere;
  }
  for (auto& [name, row] : m_rows)
    for (QWidget* widget : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.horizontal),
                            static_cast<QWidget*>(row.vertical)})
      widget->setVisible(shown.contains(name));
  check();
}

std::string ImportZeros::entered(const QLineEdit& edit) const {
  return completedAngle(edit.text().trimmed().toStdString(), m_unit);
}

void ImportZeros::mark(QLineEdit& edit, const std::string& problem, const QString& name) {
  QPalette palette;
  if (!problem.empty()) {
    palette.setColor(QPalette::Text, stateColor(palette, State::Bad));
    palette.setColor(QPalette::Base, stateTint(palette, State::Bad));
    if (m_problem.isEmpty()) m_problem = tr("Pointing zero at %1: %2").arg(name, visibleLine(problem));
  }
  edit.setPalette(palette);
  if (!edit.isReadOnly()) edit.setToolTip(visibleLine(problem));
}

/// Checks that each typed zero has two valid angles, or none.
void ImportZeros::check() {
  m_problem.clear();
  for (auto& [name, row] : m_rows) {
    const std::string horizontal = entered(*row.horizontal), vertical = entered(*row.vertical);
    const bool isOpen = !row.isTyped || row.label->isHidden() || (horizontal.empty() && vertical.empty());
    const auto whyNot = [&](const AngleRule& rule, const std::string& text) {
      const auto angle = angleEntry(rule, text, m_circle);
      return isOpen || angle ? std::string() : angle.problem().what;
    };
    mark(*row.horizontal, whyNot(horizontalRule, horizontal), name);
    mark(*row.vertical, whyNot(verticalRule, vertical), name);
  }
}

void ImportZeros::enterInto(Session& session) const {
  for (const auto& [name, row] : m_rows) {
    if (!row.isTyped || row.label->isHidden()) continue;
    PointingZero& zero = session.positions.at(row.position).zero;
    zero.horizontal = entered(*row.horizontal);
    zero.vertical = entered(*row.vertical);
  }
}

}  // namespace alidade::ui
