#include "ui/connection/wire_log.h"

#include <QFontDatabase>
#include <QTime>

#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr QChar sentSign(u'→'), receivedSign(u'←'), saidSign(u'·');

}  // namespace

WireLog::WireLog(QWidget* parent) : QPlainTextEdit(parent) {
  setReadOnly(true);
  setTabChangesFocus(true);
  setMaximumBlockCount(mostLines);
  setLineWrapMode(NoWrap);
  setUndoRedoEnabled(false);
  QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  setFont(font);
  setAccessibleName(tr("Log of the connection"));
}

void WireLog::addLine(bool isSent, const QString& shown) {
  add(isSent ? sentSign : receivedSign, shown);
}

void WireLog::addRemark(const QString& sentence) {
  add(saidSign, sentence);
}

void WireLog::add(QChar sign, const QString& text) {
  appendPlainText(QTime::currentTime().toString(QStringLiteral("HH:mm:ss.zzz ")) + sign + u' ' +
                  visibleLine(text));
}

std::string WireLog::bytes() const {
  const QString text = toPlainText();
  return text.isEmpty() ? std::string() : text.toStdString() + "\n";
}

}  // namespace alidade::ui
