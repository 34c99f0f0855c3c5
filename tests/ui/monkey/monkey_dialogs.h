#pragma once

#include <QDir>
#include <array>

#include "tests/ui/monkey/chance.h"
#include "tests/ui/support.h"

namespace alidade::ui {

/// Answers at random, with files of one folder.
class MonkeyDialogs : public ScriptedDialogs {
 public:
  MonkeyDialogs(Chance& chance, const QDir& folder) : m_chance(chance), m_folder(folder) {}

  SaveAnswer askLeave(const Unsaved&) override {
    return m_chance.of(
        std::array{SaveAnswer::Save, SaveAnswer::Discard, SaveAnswer::Discard, SaveAnswer::Cancel});
  }
  bool askDiscardOther(const QString&, Way) override { return !m_chance.oneIn(3); }
  bool askDeletePosition(const QString&, std::size_t) override { return !m_chance.oneIn(3); }
  QString askOpenPath(const QString&) override {
    return present(m_chance.oneIn(6) ? QStringLiteral("*.pdf") : QStringLiteral("*.alidade"));
  }
  QStringList askImportPaths(const QString&) override {
    const QString path = present(QStringLiteral("readings*"));
    return path.isEmpty() ? QStringList() : QStringList(path);
  }
  std::optional<SightingProtocol> askProtocol(const SightingProtocol& asked, CircleUnit) override {
    return asked;
  }
  std::optional<OwnEffect> askOwnEffect(const Session&, const OwnEffect& asked) override { return asked; }
  QString askProtocolPath(const QString&) override { return present(QStringLiteral("*.alidade-protocol")); }
  QString askRecordPath(const QString&) override { return present(QStringLiteral("*.alidade-instrument")); }
  QString askExportPath(const QString&, const QString&, const QString& suffix) override {
    return fresh(QStringLiteral("export-%1.") + suffix);
  }
  QString askSavePath(const QString&) override { return fresh(QStringLiteral("saved-%1.alidade")); }
  QString askReportPath(const QString&) override { return fresh(QStringLiteral("report-%1.pdf")); }
  std::optional<ReportChoice> askReport(const ReportQuestion& question) override {
    if (m_chance.oneIn(4)) return {};
    ReportChoice choice = question.choice;
    choice.contents.leftOut.clear();
    for (const ReportPartInfo& part : allReportParts())
      if (m_chance.oneIn(4)) choice.contents.leftOut.insert(part.part);
    return choice;
  }
  std::optional<QFont> askFont(const QFont& now) override {
    if (m_chance.oneIn(3)) return {};
    QFont other = now;
    other.setPointSizeF(m_chance.of(std::array{6.0, 9.0, 13.0, 24.0, 400.0}));
    return other;
  }
  void showProblem(const QString&, const QString&) override {}

  /// Any file of the folder; sometimes a missing one, or an empty path.
  QString present(const QString& pattern) {
    QStringList names = m_folder.entryList({pattern}, QDir::Files, QDir::Name);
    names.append(QStringLiteral("absent"));
    return m_chance.oneIn(9) ? QString() : m_folder.filePath(m_chance.of(names));
  }

 private:
  QString fresh(const QString& name) {
    if (m_chance.oneIn(9)) return {};
    if (m_chance.oneIn(20)) return m_folder.filePath(QStringLiteral("no folder/") + name.arg(1));
    return m_folder.filePath(name.arg(m_chance.below(4)));
  }

  Chance& m_chance;
  QDir m_folder;
};

}  // namespace alidade::ui
