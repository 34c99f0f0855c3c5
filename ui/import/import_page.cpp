#include "ui/import/import_page.h"

#include <QDialogButtonBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "core/base/limits.h"
#include "core/base/phrase.h"
#include "core/exchange/import.h"
#include "core/session/entry.h"
#include "core/session/row_fields.h"
#include "ui/import/import_files.h"
#include "ui/import/import_layout.h"
#include "ui/import/import_memory.h"
#include "ui/import/import_preview.h"
#include "ui/import/import_zeros.h"
#include "ui/jobs/failed_job.h"
#include "ui/panels/parts/dialog_parts.h"
#include "ui/recovery/form_draft.h"
#include "ui/text/effect_text.h"
#include "ui/text/entry_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

/// True if any row has an entry, even only a part of a reading, so that the import discards nothing typed.
bool hasReadings(const Session& session) {
  return std::ranges::any_of(session.positions, [](const Position& position) {
    return !std::ranges::all_of(position.readings, isBlank);
  });
}

Session withoutRows(Session session) {
  for (Position& position : session.positions) position.readings.clear();
  return session;
}

/// Removes rows without any entry.
Session withoutBlankRows(Session session) {
  for (Position& position : session.positions) std::erase_if(position.readings, isBlank);
  return session;
}

/// The hashes of the files, to recognise the same files later.
QString digestsOf(const std::vector<ImportSource>& sources) {
  QStringList digests;
  for (const ImportSource& source : sources) digests.append(qText(source.sha256));
  return digests.join(u' ');
}

QString counted(std::size_t count, const QString& one, const QString& many) {
  return count == 1 ? one : many.arg(qText(limits::asCount(count)));
}

}  // namespace

ImportPage::ImportPage(ImportRequest request, QWidget* parent)
    : QDialog(parent),
      m_request(std::move(request)),
      m_draft(new FormDraft(QStringLiteral("import"), digestsOf(m_request.sources), this)),
      m_hasReadings(hasReadings(*m_request.session)),
      m_choice(proposedChoice(m_request.sources)) {
  setWindowTitle(tr("Import readings"));
  setSizeGripEnabled(true);
  recallLayouts();
  m_choice.isAdded = m_hasReadings;
  m_reading = std::make_unique<Background<ImportReading>>(
      [this](const std::shared_ptr<const ImportReading>& reading) { take(reading); });
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(createFiles());
  auto* middle = new QHBoxLayout;
  middle->addWidget(createLayoutBox(), 1);
  middle->addWidget(createZeroBox());
  layout->addLayout(middle);
  layout->addWidget(createPreview(), 1);
  layout->addWidget(createModes());
  layout->addWidget(createFoot());
  resize(940, 660);
  m_files->focusOpenChoice();
  showLayout();
  read();
  m_draft->add(m_zeroPoint->objectName(), *m_zeroPoint);
  m_draft->finishWith(*this);
}

ImportPage::~ImportPage() = default;

QWidget* ImportPage::createFiles() {
  m_files = new ImportFiles(m_request.sources, m_choice.files);
  connect(m_files, &ImportFiles::chosen, this, &ImportPage::choose);
  connect(m_files, &QTableWidget::currentCellChanged, this, &ImportPage::showLayout);
  return m_files;
}

QWidget* ImportPage::createLayoutBox() {
  m_layoutBox = new QGroupBox;
  m_layout = new ImportLayout;
  auto* layout = new QVBoxLayout(m_layoutBox);
  layout->addWidget(m_layout);
  connect(m_layout, &ImportLayout::chosen, this, &ImportPage::choose);
  return m_layoutBox;
}

QWidget* ImportPage::createZeroBox() {
  auto* box = new QGroupBox(tr("Pointing zeros"));
  auto* layout = new QVBoxLayout(box);
  m_zeros = new ImportZeros(*m_draft);
  layout->addWidget(m_zeros);
  auto* named = new QHBoxLayout;
  m_zeroPoint = new QLineEdit;
  m_zeroPoint->setObjectName(QStringLiteral("import zero point"));
  m_zeroPoint->setPlaceholderText(tr("ZERO"));
  m_zeroPoint->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("ZERO POINT")));
  m_zeroPoint->setToolTip(
      tr("Sightings of the point with this name count as sightings of the pointing zero"));
  auto* label = new QLabel(tr("Na&me in the files:"));
  label->setBuddy(m_zeroPoint);
  named->addWidget(label);
  named->addWidget(m_zeroPoint, 1);
  layout->addLayout(named);
  layout->addStretch(1);
  connect(m_zeros, &ImportZeros::typed, this, &ImportPage::showState);
  connect(m_zeroPoint, &QLineEdit::textChanged, this, &ImportPage::choose);
  return box;
}

QWidget* ImportPage::createPreview() {
  auto* frame = new QWidget;
  auto* layout = new QVBoxLayout(frame);
  layout->setContentsMargins(0, 0, 0, 0);
  m_preview = new ImportPreview(this);
  m_table = new QTableView;
  m_table->setModel(m_preview);
  m_table->setObjectName(QStringLiteral("import preview"));
  m_table->setAccessibleName(tr("Preview of the readings"));
  m_table->setTabKeyNavigation(false);
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->verticalHeader()->hide();
  m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
  m_table->horizontalHeader()->setHighlightSections(false);
  m_table->setMinimumHeight(120);
  auto* label = new QLabel(tr("Pre&view:"));
  label->setBuddy(m_table);
  layout->addWidget(label);
  layout->addWidget(m_table, 1);
  return frame;
}

QWidget* ImportPage::createModes() {
  auto* box = new QWidget;
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  m_add = new QRadioButton(tr("&Add to the readings of this session"));
  auto* replace = new QRadioButton(tr("Replace: begin a new session wi&th them"));
  m_add->setObjectName(QStringLiteral("import add"));
  replace->setObjectName(QStringLiteral("import replace"));
  (m_choice.isAdded ? m_add : replace)->setChecked(true);
  layout->addWidget(m_add);
  layout->addWidget(replace);
  layout->addStretch(1);
  box->setVisible(m_hasReadings);
  connect(m_add, &QRadioButton::toggled, this, &ImportPage::choose);
  return box;
}

QWidget* ImportPage::createFoot() {
  auto* foot = new QWidget;
  auto* layout = new QVBoxLayout(foot);
  layout->setContentsMargins(0, 0, 0, 0);
  m_problems = new QPlainTextEdit;
  m_problems->setObjectName(QStringLiteral("import problems"));
  m_problems->setAccessibleName(tr("What cannot be used, and remarks"));
  m_problems->setReadOnly(true);
  m_problems->setTabChangesFocus(true);
  m_problems->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_summary = createPlainLabel({});
  m_summary->setObjectName(QStringLiteral("import summary"));
  QFont bold = m_summary->font();
  bold.setBold(true);
  m_summary->setFont(bold);
  m_buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  m_buttons->button(QDialogButtonBox::Ok)->setText(tr("&Import"));
  m_buttons->button(QDialogButtonBox::Ok)->setDefault(true);
  auto* last = new QHBoxLayout;
  last->addWidget(m_summary, 1);
  last->addWidget(m_buttons);
  layout->addWidget(m_problems);
  layout->addLayout(last);
  connect(m_buttons, &QDialogButtonBox::accepted, this, &ImportPage::accept);
  connect(m_buttons, &QDialogButtonBox::rejected, this, &ImportPage::reject);
  return foot;
}

/// Restores the remembered layouts; the session's instrument supplies a unit that nothing else determines.
void ImportPage::recallLayouts() {
  for (const ImportSource& source : m_request.sources) {
    const std::string signature = source.recognised.signature();
    if (!m_choice.layouts.contains(signature)) continue;
    if (const auto layout = ImportMemory::layoutOf(source.recognised)) {
      m_choice.layouts[signature] = *layout;
      m_remembered.insert(signature);
    }
    TableLayout& layout = m_choice.layouts[signature];
    const CircleUnit unit = circleUnitOf(*m_request.session);
    if (source.recognised.asksUnit && layout.unit == AngleUnit::Unstated && unit != CircleUnit::Dms)
      layout.unit = unit == CircleUnit::Gon ? AngleUnit::Gon : AngleUnit::Degrees;
  }
}

void ImportPage::showLayout() {
  const ImportSource& source = m_request.sources.at(m_files->current());
  const std::string signature = source.recognised.signature();
  const auto layout = m_choice.layouts.find(signature);
  m_layout->show(source, layout == m_choice.layouts.end() ? TableLayout() : layout->second,
                 m_remembered.contains(signature));
  const auto alike = std::ranges::count_if(m_request.sources, [&](const ImportSource& other) {
    return other.recognised.signature() == signature;
  });
  const QString name = shortLine(source.name, 40);
  m_layoutBox->setTitle(alike > 1 ? tr("Layout of “%1” and those like it").arg(name)
                                  : tr("Layout of “%1”").arg(name));
}

void ImportPage::choose() {
  m_choice.files = m_files->choices();
  const std::string signature = m_request.sources.at(m_files->current()).recognised.signature();
  if (m_choice.layouts.contains(signature)) m_choice.layouts[signature] = m_layout->layout();
  m_choice.zeroPoint = m_zeroPoint->text().trimmed().toStdString();
  m_choice.isAdded = m_hasReadings && m_add->isChecked();
  m_isCurrent = false;
  if (!m_reading->isAtWork()) read();
  showState();
}

void ImportPage::read() {
  m_isCurrent = true;
  m_reading->start(
      [sources = m_request.sources, choice = m_choice, session = m_request.session,
       isNew = m_hasReadings](const std::stop_token&) {
        if (choice.isAdded) return readImport(sources, choice, withoutBlankRows(*session));
        return readImport(sources, choice, isNew ? blankSession() : withoutRows(*session));
      },
      [](const std::string& reason) {
        return ImportReading{.import = {},
                             .problem = reportFailure(
                                 {.job = PHRASE_LATER("Phrase", "reading of the files"), .reason = reason})};
      });
}

void ImportPage::take(std::shared_ptr<const ImportReading> reading) {
  if (!m_isCurrent) return read();
  m_shown = std::move(reading);
  showReading();
}

void ImportPage::showReading() {
  m_preview->setReading(m_shown);
  m_zeros->show(m_shown->import ? &*m_shown->import : nullptr);
  m_table->resizeColumnsToContents();
  for (int column = 0; column < ImportPreview::columns; ++column)
    m_table->setColumnHidden(column, !m_preview->isShown(static_cast<ImportPreview::Column>(column)));
  m_table->horizontalHeader()->setStretchLastSection(m_preview->isShown(ImportPreview::Column::Note));
  showProblems();
  showState();
}

void ImportPage::showProblems() {
  QStringList sentences;
  bool isUnitOpen = false;  // true: problems about the unit are hidden, since `obstacle` asks for it
  for (std::size_t i = 0; i < m_request.sources.size(); ++i) isUnitOpen = isUnitOpen || asksUnit(i);
  for (const ProblemGroup& kind : m_shown->kinds)
    if (!isUnitOpen || !kind.first.asksUnit) sentences.append(capitalised(visibleLine(kind.text())) + u'.');
  if (m_shown->import) sentences += remarks();
  constexpr qsizetype most = 200, mostLines = 4;
  if (sentences.size() > most) {
    const qsizetype more = sentences.size() - most;
    sentences = sentences.mid(0, most);
    sentences.append(tr("And %1 more.").arg(more));
  }
  m_problems->setPlainText(sentences.join(u'\n'));
  m_problems->setVisible(!sentences.isEmpty());
  const int lines = static_cast<int>(std::min(sentences.size(), mostLines));
  m_problems->setFixedHeight(lines * m_problems->fontMetrics().lineSpacing() + 14);
}

/// How each file is read, and whether it was imported before. `obstacle` reports missing positions instead.
QStringList ImportPage::remarks() const {
  QStringList remarks;
  for (const ImportSource& source : m_request.sources)
    if (m_choice.isAdded &&
        std::ranges::any_of(m_request.session->journal, [&source](const JournalEntry& entry) {
          return entry.why == journal_reasons::imported && entry.to.ends_with(source.sha256);
        }))
      remarks.append(tr("“%1” was imported into this session before.").arg(shortLine(source.name, 40)));
  for (const std::string& remark : m_shown->import->remarks)
    if (!remark.ends_with(Phrase::of(putAtZero))) remarks.append(capitalised(visibleLine(remark)) + u'.');
  return remarks;
}

QString ImportPage::unplacedFile() const {
  for (std::size_t i = 0; i < m_choice.files.size(); ++i)
    if (m_choice.files[i].where == FileChoice::Where::Unknown) {
      const bool isSaid = m_shown && m_shown->import &&
                          std::ranges::find(m_shown->import->unplaced, i) == m_shown->import->unplaced.end();
      if (!isSaid) return m_request.sources[i].name;
    }
  return {};
}

/// True if the user must choose the unit, since the numbers of the file may have any unit.
bool ImportPage::asksUnit(std::size_t source) const {
  const Recognised& recognised = m_request.sources[source].recognised;
  const auto layout = m_choice.layouts.find(recognised.signature());
  return recognised.asksUnit && layout != m_choice.layouts.end() &&
         layout->second.unit == AngleUnit::Unstated;
}

QString ImportPage::obstacle() const {
  for (std::size_t i = 0; i < m_request.sources.size(); ++i) {
    const ImportSource& source = m_request.sources[i];
    const QString name = shortLine(source.name, 40);
    const auto layout = m_choice.layouts.find(source.recognised.signature());
    if (layout != m_choice.layouts.end() && !hasCircles(layout->second))
      return tr("Choose the columns of the horizontal and the vertical circle of “%1”.").arg(name);
    if (asksUnit(i)) return tr("“%1” does not state the unit of its angles: choose it.").arg(name);
  }
  if (m_shown && !m_shown->import) return capitalised(visibleLine(m_shown->problem)) + u'.';
  if (const QString name = unplacedFile(); !name.isEmpty())
    return tr("“%1” does not state the position it was read at: choose it.").arg(shortLine(name, 40));
  if (!m_zeros->problem().isEmpty()) return m_zeros->problem();
  if (m_shown && m_shown->import->rows == 0) return tr("There are no readings besides the pointing zeros.");
  return {};
}

QString ImportPage::summary() const {
  const Import& import = *m_shown->import;
  QString text = counted(import.rows, tr("1 row of readings"), tr("%1 rows of readings"));
  if (const std::size_t odd = import.problems.size(); odd > 0)
    text += counted(odd, tr("; 1 entry or line cannot be used"), tr("; %1 entries or lines cannot be used"));
  return text + u'.';
}

void ImportPage::showState() {
  const QString obstacle = this->obstacle();
  const bool isReady = m_shown && m_isCurrent && obstacle.isEmpty();
  m_buttons->button(QDialogButtonBox::Ok)->setEnabled(isReady);
  if (!obstacle.isEmpty())
    m_summary->setText(obstacle);
  else
    m_summary->setText(isReady ? summary() : tr("Reading…"));
}

ImportDecision ImportPage::decision() const {
  std::vector<ImportedFile> files;
  for (const ImportSource& source : m_request.sources)
    files.push_back({source.name.toStdString(), source.sha256});
  ImportDecision decision{.session = m_shown->import->session,
                          .isAdded = m_choice.isAdded || !m_hasReadings,
                          .origins = importEntries(*m_shown->import, files),
                          .rows = m_shown->import->rows};
  m_zeros->enterInto(decision.session);
  if (decision.session.title.empty()) decision.session.title = m_request.sources.front().title.toStdString();
  return decision;
}

void ImportPage::accept() {
  if (!isUpToDate() || !obstacle().isEmpty()) return;
  for (const ImportSource& source : m_request.sources)
    if (const auto layout = m_choice.layouts.find(source.recognised.signature());
        layout != m_choice.layouts.end())
      ImportMemory::keep(source.recognised, layout->second);
  QDialog::accept();
}

std::optional<ImportDecision> ImportPage::ask() {
  if (exec() != Accepted) return std::nullopt;
  return decision();
}

}  // namespace alidade::ui
