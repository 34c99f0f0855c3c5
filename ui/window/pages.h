#pragma once

#include <span>

#include "core/session/own_effect.h"
#include "ui/panels/window/page_tabs.h"

namespace alidade::ui {

class Dialogs;
class ExportFlow;
class FileFlow;
class InstrumentFlow;
class PositionTabs;
class ProtocolFlow;
class ResultColumn;
class SessionDocument;
class SessionJobs;

/// The parts of the window that pages are connected to.
struct WindowParts {
  SessionDocument& document;
  SessionJobs& jobs;
  Dialogs& dialogs;
  FileFlow& files;
  ExportFlow& exports;
  InstrumentFlow& instrument;
  ProtocolFlow& protocol;
  PositionTabs& positions;
};

/// A page as created: its widget, and how `PageTabs` shows it.
struct MadePage {
  QWidget* widget;
  PageTabs::Show show;
  PageTabs::Wanted wanted = {};
};

enum class PageSide { Beside, Below };  ///< side of the picture of the arcs

/// A page of the window.
struct PageInfo {
  const char* id;
  const char* title;      ///< in the context `alidade::ui::MainWindow`
  const char* helpTopic;  ///< in the guide
  const char* keys;       ///< its shortcut
  PageSide side;
  MadePage (*make)(const WindowParts& parts, ResultColumn& column);  ///< creates and connects the page
};

/// All pages in the order of tabs and menu.
std::span<const PageInfo> allPages();

/// Lets the user edit `effect` as an effect of their own, and keeps the result in the session.
void typeOwnEffect(const WindowParts& parts, const OwnEffect& effect);

/// The page of the gap, whose actions edit the session.
MadePage makeGapPage(const WindowParts& parts, ResultColumn& column);

}  // namespace alidade::ui
