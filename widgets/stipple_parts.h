#pragma once

#include "widgets/part_form.h"

#include <vector>

namespace limner {

/// The parts that marks of ink may have, as they stand in the panel.
std::vector<PartForm*> stippleFactorForms();
std::vector<PartForm*> stippleLineForms();

} // namespace limner
