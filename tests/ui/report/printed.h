#pragma once

#include <QDateTime>
#include <QString>
#include <QTemporaryDir>

#include "core/evaluation/evaluation.h"
#include "ui/report/acceptance_report.h"

namespace alidade::ui {

/// The text of a report file, read by poppler; blanks in rows are reduced to one, pages end in form feeds.
QString printedText(const QString& path);

/// A written report, read back by poppler's programs.
class Printed {
 public:
  explicit Printed(const Session& session, const ReportSource& source = savedSource());
  Printed(const Session& session, ReportOptions options);

  QString path() const { return m_folder.filePath(QStringLiteral("report.pdf")); }
  int pageCount() const { return static_cast<int>(m_pages.size()); }
  /// The text of one page, counted from 0, with its lines; blanks in rows are reduced to one.
  const QString& page(int index) const { return m_pages.at(index); }
  QString text() const { return m_pages.join(u'\n'); }
  bool contains(const char* text) const;

  /// The output of a poppler program for the file.
  QString tool(const QString& program, const QStringList& arguments = {}) const;

  static ReportSource savedSource();
  static QDateTime date() { return QDateTime(QDate(2026, 3, 14), QTime(15, 9)); }

 private:
  void write(const Session& session, const ReportSource& source, const ReportOptions& options);

  QTemporaryDir m_folder;
  QStringList m_pages;
};

}  // namespace alidade::ui
