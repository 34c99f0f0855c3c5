#include "ui/panels/readings/find_bar.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <algorithm>
#include <string>
#include <vector>

#include "core/base/typed_text.h"
#include "core/session/row_fields.h"
#include "ui/text/entry_text.h"

namespace alidade::ui {

namespace {

std::string digitsOf(const std::string& text) {
  std::string digits;
  std::ranges::copy_if(text, std::back_inserter(digits), isDigit);
  return digits;
}

class Wanted {
 public:
  explicit Wanted(const QString& text) : m_text(text.toLower()) {
    const std::string typed = plainSigns(text.toStdString());
    const bool isNumber = !typed.empty() && std::ranges::all_of(typed, [](char c) {
      return isDigit(c) || std::string_view(" .,-'\":/").find(c) != std::string_view::npos ||
             static_cast<unsigned char>(c) >= 0x80;
    });
    if (isNumber) m_digits = digitsOf(typed);
  }

  bool isIn(const std::string& text, bool isAngle) const {
    if (text.empty()) return false;
    if (isAngle && !m_digits.empty()) return digitsOf(text).find(m_digits) != std::string::npos;
    return qText(text).contains(m_text, Qt::CaseInsensitive);
  }

 private:
  QString m_text;
  std::string m_digits;  ///< digits of a typed number, for the search in angles; empty: no number
};

std::vector<const RowField*> textFields() {
  std::vector<const RowField*> fields;
  for (const RowField& field : rowFields)
    if (field.text) fields.push_back(&field);
  return fields;
}

QToolButton* arrow(Qt::ArrowType type, const QString& name) {
  auto* button = new QToolButton;
  button->setArrowType(type);
  button->setAutoRaise(true);
  button->setToolTip(name);
  button->setAccessibleName(name);
  return button;
}

}  // namespace

FindBar::FindBar(QWidget* parent) : QFrame(parent), m_text(new QLineEdit), m_message(new QLabel) {
  m_text->setObjectName(QStringLiteral("find"));
  m_text->setAccessibleName(tr("Find in the readings"));
  m_text->setPlaceholderText(tr("Find in the readings"));
  m_text->setClearButtonEnabled(true);
  m_text->installEventFilter(this);
  QToolButton* previous = arrow(Qt::UpArrow, tr("Previous (Shift+F3)"));
  QToolButton* next = arrow(Qt::DownArrow, tr("Next (F3)"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(m_text, 1);
  layout->addWidget(previous);
  layout->addWidget(next);
  layout->addWidget(m_message);
  connect(previous, &QToolButton::clicked, this, [this] { ask(false); });
  connect(next, &QToolButton::clicked, this, [this] { ask(true); });
  hide();
}

void FindBar::start() {
  show();
  m_text->setFocus(Qt::ShortcutFocusReason);
  m_text->selectAll();
}

void FindBar::showMessage(const QString& text) {
  m_message->setText(text);
}

void FindBar::ask(bool forward) {
  if (!m_text->text().isEmpty()) emit wanted(m_text->text(), forward);
}

bool FindBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched != m_text || event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() == Qt::Key_Escape) {
    hide();
    emit closed();
    return true;
  }
  if (key->key() != Qt::Key_Return && key->key() != Qt::Key_Enter) return false;
  ask(!key->modifiers().testFlag(Qt::ShiftModifier));
  return true;
}

std::optional<Place> findInReadings(const Session& session, const Place& from, const QString& text,
                                    bool forward) {
  static const std::vector<const RowField*> fields = textFields();
  const Wanted wanted(text);
  const std::size_t columns = fields.size();
  std::vector<std::size_t> begins{0};  // index of the first cell of each position
  for (const Position& position : session.positions)
    begins.push_back(begins.back() + position.readings.size() * columns);
  const std::size_t count = begins.back();
  if (count == 0 || text.isEmpty()) return {};
  const std::size_t position = std::min(from.position.value_or(0), session.positions.size() - 1);
  const auto field = std::ranges::find(fields, std::string_view(from.field), &RowField::key);
  const std::size_t column = field == fields.end() ? 0 : static_cast<std::size_t>(field - fields.begin());
  std::size_t cell =
      std::min(begins[position] + from.reading.value_or(0) * columns + column, begins[position + 1]);
  std::size_t at = position;
  for (std::size_t looked = 0; looked < count; ++looked) {
    cell = forward ? (cell + 1) % count : (cell + count - 1) % count;
    while (cell >= begins[at + 1] || cell < begins[at]) at = (at + 1) % session.positions.size();
    const std::size_t within = cell - begins[at];
    const RowField& own = *fields[within % columns];
    if (wanted.isIn(session.positions[at].readings[within / columns].*own.text, isAngle(own)))
      return Place{.position = at, .reading = within / columns, .field = std::string(own.key)};
  }
  return {};
}

}  // namespace alidade::ui
