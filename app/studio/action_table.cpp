#include "app/studio/action_table.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeySequence>
#include <QMainWindow>
#include <QSettings>

#include <cassert>

namespace limner {
namespace {

#define TEXT(words) QT_TRANSLATE_NOOP("Actions", words)

constexpr ActionRow kActions[] = {
    {"file.open", TEXT("&Open…"), TEXT("Open a scan, a project or a figure"), "Ctrl+O", TEXT("Open")},
    {"file.open-folder", TEXT("Open &folder of slices…"),
     TEXT("Open a folder with a DICOM series or a stack of pictures"), "Ctrl+Shift+O", ""},
    {"file.open-labels", TEXT("Open &labels…"), TEXT("Open a volume of label numbers that belongs to the scan"), "",
     ""},
    {"file.sample", TEXT("Open s&ample head"), TEXT("Open the built-in head, to try things out"), "", ""},
    {"file.recent", TEXT("Open &recent"), TEXT("Scans and projects that were open lately"), "", ""},
    {"file.-1", "", "", "", ""},
    {"file.save", TEXT("&Save"), TEXT("Save the project"), "Ctrl+S", TEXT("Save")},
    {"file.save-as", TEXT("Save &as…"), TEXT("Save the project under another name"), "Ctrl+Shift+S", ""},
    {"file.save-copy", TEXT("Save a cop&y…"), TEXT("Save the project as it is under another name, and go on with this"),
     "", ""},
    {"file.revert", TEXT("Re&vert to saved"), TEXT("The figure as it was saved last; Undo brings the changes back"), "",
     ""},
    {"file.pack", TEXT("&Pack the scan into the project"),
     TEXT("Keep the scan inside the project file, so that it can be moved and sent alone"), "", ""},
    {"file.-2", "", "", "", ""},
    {"file.export", TEXT("&Export picture…"), TEXT("Write the figure as a picture with a size in millimetres"),
     "Ctrl+E", TEXT("Export")},
    {"file.-3", "", "", "", ""},
    {"file.close", TEXT("&Close"), TEXT("Close the document"), "Ctrl+W", ""},
    {"file.quit", TEXT("&Quit"), TEXT("Leave Limner Studio"), "Ctrl+Q", ""},
    {"edit.undo", TEXT("&Undo"), TEXT("Take back the last change"), "Ctrl+Z", TEXT("Undo")},
    {"edit.redo", TEXT("&Redo"), TEXT("Repeat what was taken back"), "Ctrl+Shift+Z", TEXT("Redo")},
    {"edit.name-state", TEXT("&Name this state…"),
     TEXT("Keep the figure as it is now under a name, to come back to it"), "", ""},
    {"edit.-1", "", "", "", ""},
    {"edit.copy-picture", TEXT("&Copy picture"), TEXT("Copy the shown picture to the clipboard"), "Ctrl+Shift+C", ""},
    {"edit.-2", "", "", "", ""},
    {"edit.add-lens", TEXT("Add &lens"), TEXT("Add a lens under which what matters shows through"), "Ctrl+L", ""},
    {"edit.stipple", TEXT("St&ipple"), TEXT("Draw the figure with dots and lines of ink, and show their panel"),
     "Ctrl+I", ""},
    {"edit.add-label", TEXT("Add la&bel"), TEXT("Click on a structure in the picture and write its name"), "T", ""},
    {"edit.-3", "", "", "", ""},
    {"edit.scissors", TEXT("&Scissors"), TEXT("Cut away what an outline drawn in the picture encloses"), "X", ""},
    {"edit.keep-island", TEXT("&Keep the island here"),
     TEXT("Click on the part that stays; what is not connected with it goes"), "K", ""},
    {"edit.widen-range", TEXT("&Widen the opacity's range"),
     TEXT("Drag over a structure in the picture: the chosen layer comes to show its values"), "W", ""},
    {"edit.-4", "", "", "", ""},
    {"edit.find-settings", TEXT("Find settings for the &accuracy"),
     TEXT("Find the settings that keep the chosen error in the least time, and set them"), "", ""},
    {"view.measure", TEXT("&Measure"), TEXT("Click on two places of the figure: how far they are from each other"), "M",
     ""},
    {"view.anterior", TEXT("&Anterior"), TEXT("Look at the patient's front"), "1", TEXT("Front")},
    {"view.posterior", TEXT("&Posterior"), TEXT("Look at the patient's back"), "2", TEXT("Back")},
    {"view.left", TEXT("&Left"), TEXT("Look at the patient's left side"), "3", TEXT("Left")},
    {"view.right", TEXT("&Right"), TEXT("Look at the patient's right side"), "4", TEXT("Right")},
    {"view.superior", TEXT("&Superior"), TEXT("Look from above the head"), "5", TEXT("Above")},
    {"view.inferior", TEXT("&Inferior"), TEXT("Look from below the feet"), "6", TEXT("Below")},
    {"view.three-quarter", TEXT("&Three-quarter"), TEXT("Look from the front, turned and from a little above"), "0",
     TEXT("3/4")},
    {"view.-1", "", "", "", ""},
    {"view.fit", TEXT("&Fit"), TEXT("Fill the sheet with what is visible"), "F", TEXT("Fit")},
    {"view.zoom-in", TEXT("Zoom &in"), TEXT("Show a smaller part, larger"), "Ctrl++", ""},
    {"view.zoom-out", TEXT("Zoom &out"), TEXT("Show more, smaller"), "Ctrl+-", ""},
    {"view.-2", "", "", "", ""},
    {"view.free-turning", TEXT("Turn freel&y"), TEXT("Turn about any axis instead of keeping the horizon level"), "",
     ""},
    {"view.error-map", TEXT("Show &error over the picture"),
     TEXT("Lay over the picture how far each pixel is off, until the figure or the view changes"), "", ""},
    {"looks.variants", TEXT("&Variants…"),
     TEXT("A sheet of the figure in other looks, or with a setting at several values; take one"), "Ctrl+Shift+V", ""},
    {"looks.-1", "", "", "", ""},
    {"looks.mine", TEXT("&Mine"), TEXT("Lay a look of your own over the figure"), "", ""},
    {"looks.keep", TEXT("&Keep this look…"),
     TEXT("Keep styles, layers and ink of this figure under a name, for other scans"), "", ""},
    {"looks.import", TEXT("&Import look…"), TEXT("Take the look of a file or of a project into your own looks"), "",
     ""},
    {"looks.remove", TEXT("&Remove"), TEXT("Delete one of your own looks"), "", ""},
    {"styles.find", TEXT("&Find a style"), TEXT("Search the gallery of styles"), "Ctrl+F", ""},
    {"styles.import", TEXT("&Import picture…"), TEXT("Add a picture of a shaded ball to your own styles"), "", ""},
    {"styles.extract", TEXT("Take from &artwork…"), TEXT("Take a style from a scanned drawing or painting"), "Ctrl+T",
     ""},
    {"background.paper", TEXT("Paper &colour…"), TEXT("Lay the figure on a plain paper of a colour"), "", ""},
    {"background.picture", TEXT("&Picture…"), TEXT("Lay the figure over a picture, an artwork or a sheet of paper"), "",
     ""},
    {"window.commands", TEXT("&Commands…"), TEXT("Find any command by its name and do it"), "Ctrl+Shift+P", ""},
    {"window.shortcuts", TEXT("&Shortcuts…"), TEXT("See and change the keys of all commands"), "", ""},
    {"window.layouts", TEXT("&Layouts"), TEXT("Arrangements of the panels"), "", ""},
    {"window.theme", TEXT("Co&lours"), TEXT("Light or dark colours of the window"), "", ""},
    {"window.backend", TEXT("Pictures dra&wn by"),
     TEXT("What draws the pictures: a graphics card by OpenGL, or the processor; the change shows at the next start"),
     "", ""},
    {"window.language", TEXT("Lan&guage"), TEXT("Language of the window; the change shows at the next start"), "", ""},
    {"window.only-picture", TEXT("Only the &picture"), TEXT("Hide all panels, or bring them back"), "Shift+F11", ""},
    {"window.full-screen", TEXT("&Full screen"), TEXT("Use the whole screen, or the window again"), "F11", ""},
    {"window.-1", "", "", "", ""},
    {"help.about", TEXT("&About Limner"), TEXT("Version and licence"), "", ""},
};

#undef TEXT

QString settingOf(const QString& id) { return "shortcuts/" + id; }

void giveKeys(QAction& action, const QKeySequence& keys) {
    const QString tip = action.statusTip();
    action.setShortcut(keys);
    action.setToolTip(keys.isEmpty() ? tip : Actions::tr("%1 (%2)").arg(tip, keys.toString(QKeySequence::NativeText)));
}

QString translated(const char* text) { return QCoreApplication::translate("Actions", text); }

} // namespace

std::span<const ActionRow> actionTable() { return kActions; }

Actions::Actions(QMainWindow* window) : QObject(window) {
    for (const ActionRow& row : actionTable()) {
        auto* action = new QAction(*row.text ? translated(row.text) : QString(), window);
        action->setObjectName(row.id);
        action->setSeparator(!*row.text);
        if (*row.text) {
            action->setStatusTip(translated(row.tip));
            const QVariant own = QSettings().value(settingOf(row.id));
            giveKeys(*action,
                     own.isValid() ? QKeySequence(own.toString(), QKeySequence::PortableText) : standardShortcut(row));
            if (*row.brief)
                action->setIconText(translated(row.brief));
        }
        actions_.insert(row.id, action);
    }
}

QKeySequence Actions::standardShortcut(const ActionRow& row) { return {row.shortcut, QKeySequence::PortableText}; }

void Actions::setShortcut(const QString& id, const QKeySequence& keys) {
    giveKeys(*at(id), keys);
    for (const ActionRow& row : actionTable())
        if (id == row.id && keys == standardShortcut(row)) {
            QSettings().remove(settingOf(id));
            return;
        }
    QSettings().setValue(settingOf(id), keys.toString(QKeySequence::PortableText));
}

QAction* Actions::at(const QString& id) const {
    QAction* action = actions_.value(id);
    assert(action);
    return action;
}

} // namespace limner
