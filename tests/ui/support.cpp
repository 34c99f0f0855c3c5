#include "tests/ui/support.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QPointer>
#include <QPrinter>
#include <QScopeGuard>
#include <QTest>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/session/session_file.h"
#include "core/simulation/simulate.h"
#include "ui/import/import_page.h"
#include "ui/main_window.h"

namespace alidade::ui {

bool ScriptedDialogs::printsTo(QPrinter& printer, const QString& path) {
  if (path.isEmpty()) return false;
  printer.setOutputFormat(QPrinter::PdfFormat);
  printer.setOutputFileName(path);
  return true;
}

PreviewAnswer ScriptedDialogs::showPreview(QPrinter& printer, const std::function<void(QPrinter&)>& paint,
                                           const PreviewChange& change) {
  while (true) {
    const int preview = previews++;
    if (printsTo(printer, previewPaths.value(preview))) paint(printer);
    const auto index = static_cast<std::size_t>(preview);
    const PreviewAnswer answer = index < previewAnswers.size() ? previewAnswers[index] : PreviewAnswer::Close;
    if (answer != PreviewAnswer::Contents && answer != PreviewAnswer::Page) return answer;
    change(answer);
  }
}

OpenWindow::OpenWindow() {
  auto scripted = std::make_unique<ScriptedDialogs>();
  dialogs = scripted.get();
  window = std::make_unique<MainWindow>(std::move(scripted));
  window->show();
  QApplication::setActiveWindow(window.get());
  waitUntilIdle();
}

OpenWindow::~OpenWindow() {
  window.reset();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

void OpenWindow::waitUntilIdle() {
  if (!waitFor([this] { return window->job().isIdle(); })) throw std::runtime_error("the fit does not end");
  QCoreApplication::processEvents();
}

QString samplePath(const QString& name) {
  return QStringLiteral(ALIDADE_SAMPLES_DIR "/") + name;
}

Session paperSession() {
  const Result<Session> session =
      loadSession(samplePath(QStringLiteral("paper-table-1.alidade")).toStdString());
  if (!session) throw std::runtime_error(session.problem().text());
  return *session;
}

Session sessionTakenAt(const std::vector<int>& axes) {
  Protocol protocol = *protocolByName("paper");
  protocol.axes = axes;
  const Result<Session> simulated = simulate(protocol, drawTruth(5), 5);
  if (!simulated) throw std::runtime_error(simulated.problem().text());
  Session session = *simulated;
  session.acceptance.toleranceMm = "2.5";
  return session;
}

Session sessionInTwoFaces() {
  const Result<Session> simulated = simulate(*protocolByName("full"), drawTruth(5), 5);
  if (!simulated) throw std::runtime_error(simulated.problem().text());
  return *simulated;
}

std::string paperTextWithEffects(const std::vector<std::string>& effects) {
  auto json = nlohmann::ordered_json::parse(writeSession(paperSession()));
  json["model"]["effects"] = effects;
  return json.dump();
}

namespace {

/// QTest supports keys for ASCII only.
void type(QWidget& widget, QChar character) {
  if (character >= u' ' && character <= u'~')
    QTest::keyClicks(&widget, QString(character));
  else
    QTest::sendKeyEvent(QTest::Click, &widget, static_cast<Qt::Key>(character.toUpper().unicode()),
                        QString(character), Qt::NoModifier);
}

}  // namespace

void typeInto(QWidget& widget, const QString& text, Qt::Key key) {
  widget.setFocus();
  for (const QChar character : text) {
    QWidget* focus = QApplication::focusWidget();
    type(focus ? *focus : widget, character);
  }
  QWidget* focus = QApplication::focusWidget();
  QTest::keyClick(focus ? focus : &widget, key);
}

bool waitFor(const std::function<bool()>& done) {
  QElapsedTimer clock;
  clock.start();
  while (!done()) {
    if (clock.elapsed() > 60'000) return false;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10);
  }
  return true;
}

std::optional<ImportDecision> ScriptedDialogs::askImport(ImportRequest request) {
  ++importsAsked;
  const QPointer<QWidget> before = QApplication::activeWindow();
  ImportPage page(std::move(request));
  const auto leave = qScopeGuard([&] {
    page.hide();
    if (before) before->activateWindow();
  });
  page.show();
  const auto waitUntilIdle = [&page] { return waitFor([&page] { return page.isUpToDate(); }); };
  if (!waitUntilIdle()) return std::nullopt;
  if (onImport) onImport(page);
  if (!waitUntilIdle() || !page.obstacle().isEmpty()) return std::nullopt;
  page.accept();
  return page.decision();
}

}  // namespace alidade::ui
