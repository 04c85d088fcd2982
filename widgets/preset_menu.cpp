#include "widgets/preset_menu.h"

#include "widgets/core_words.h"

namespace limner {

PresetMenu::PresetMenu(QWidget* parent) : QMenu(tr("&Preset"), parent) { setToolTipsVisible(true); }

void PresetMenu::setPresets(const std::vector<PresetCard>& presets) {
    clear();
    needLabels_.clear();
    for (const PresetCard& card : presets) {
        const QString id = QString::fromStdString(card.id);
        const QString name = coreWord(card.name);
        const QString modality = QString::fromStdString(card.modality);
        QAction* action =
            addAction(card.modality == "any" || card.modality == "labels" ? name : tr("%1 (%2)").arg(name, modality));
        action->setObjectName("preset." + id);
        action->setToolTip(coreWord(card.help));
        action->setStatusTip(action->toolTip());
        connect(action, &QAction::triggered, this, [this, id, name] { Q_EMIT chosen(id, name); });
        if (card.modality == "labels")
            needLabels_.push_back(action);
        if (card.id == "auto")
            addSeparator();
    }
    setLabelsThere(labelsThere_);
}

void PresetMenu::setLabelsThere(bool there) {
    labelsThere_ = there;
    for (QAction* action : needLabels_)
        action->setEnabled(there);
}

} // namespace limner
