#include "PointerModes.h"

#include <algorithm>

namespace palpate
{
void PointerModes::Add(QAction* mode)
{
  this->Modes.append(mode);
  this->connect(mode, &QAction::toggled, this, [this, mode](bool isOn) { this->Take(mode, isOn); });
}

void PointerModes::Take(QAction* mode, bool isOn)
{
  for (QAction* other : this->Modes)
  {
    if (isOn && other != mode)
    {
      other->setChecked(false);
    }
  }
  Q_EMIT Changed();
}

bool PointerModes::IsAny() const
{
  return std::any_of(this->Modes.begin(), this->Modes.end(),
                     [](const QAction* mode) { return mode->isChecked(); });
}

void PointerModes::Leave()
{
  for (QAction* mode : this->Modes)
  {
    mode->setChecked(false);
  }
}
} // namespace palpate
