#include "ui/document/session_files.h"

#include <QFileInfo>

namespace alidade::ui {

namespace {

/// Compares files rather than the spelling of their paths.
bool areSameFile(const QString& one, const QString& other) {
  const QString canonical = QFileInfo(one).canonicalFilePath();  // empty if the file is missing
  return one == other || (!canonical.isEmpty() && canonical == QFileInfo(other).canonicalFilePath());
}

}  // namespace

void SessionFiles::restart(const QString& path) {
  m_files = {{.path = path, .session = ++m_lastSession, .savedAt = 0}};
}

void SessionFiles::dropFrom(int index) {
  m_files.resize(at(index) + 1);
  File& present = m_files.back();
  if (present.savedAt > index) present.savedAt = -1;
  present.isGivenUp = false;
}

void SessionFiles::beginAnother(int index) {
  m_files.back().isGivenUp = isModified(index);
  m_files.push_back({.session = ++m_lastSession, .begins = index + 1});
}

void SessionFiles::setSaved(int index, const QString& path) {
  const std::size_t present = at(index);
  for (std::size_t i = 0; i < m_files.size(); ++i) {
    if (i == present || !areSameFile(m_files[i].path, path)) continue;
    m_files[i].path.clear();
    m_files[i].savedAt = -1;
    m_files[i].isGivenUp = true;
  }
  m_files[present].path = path;
  m_files[present].savedAt = index;
}

QStringList SessionFiles::paths() const {
  QStringList paths;
  for (const File& file : m_files)
    if (!file.path.isEmpty()) paths.append(file.path);
  return paths;
}

std::optional<QString> SessionFiles::unsavedAhead(int index, int count) const {
  for (std::size_t i = at(index) + 1; i < m_files.size(); ++i)
    if (isUnsaved(i, count)) return m_files[i].path;
  return {};
}

std::optional<QString> SessionFiles::unsavedBehind(int index, int count) const {
  for (std::size_t i = 0; i < at(index); ++i)
    if (!m_files[i].isGivenUp && isUnsaved(i, count)) return m_files[i].path;
  return {};
}

/// The index in `m_files` of the session that is current at the stack index `index`.
std::size_t SessionFiles::at(int index) const {
  std::size_t file = m_files.size() - 1;
  while (file > 0 && m_files[file].begins > index) --file;
  return file;
}

bool SessionFiles::isUnsaved(std::size_t file, int count) const {
  const int last = file + 1 < m_files.size() ? m_files[file + 1].begins - 1 : count;
  return m_files[file].savedAt != last;
}

}  // namespace alidade::ui
