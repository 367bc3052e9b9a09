#pragma once

#include "LeftOutDistance.h"
#include "PalpateGroupModule.h"

#include <vector>

namespace palpate
{
/// For each case of a group the probability of a normal case that is as far from the others or
/// farther; `distances` are those of all cases, each itself left out.
///
/// In directions fixed in advance F of LeftOutDistance is Fisher's (Hotelling), and says the same
/// as the distance of a case inside its group, whose square times n / (n - 1)^2 is beta distributed
/// (Gnanadesikan and Kettenring, Biometrics 28, 1972), since one grows with the other. Modes were
/// chosen for the others' variance, so that it exceeds a new case's there and F is too small. By
/// how much is measured by prediction: the mean F of all left-out cases over the mean of Fisher's
/// distribution. F is divided by that, if it is less than 1. To limit what unusual cases
/// contribute, F counts to its 99.9 % point only.
///
/// 1 where F has no degrees of freedom. Allocates.
PALPATEGROUP_EXPORT Eigen::VectorXd
LeftOutProbabilities(const std::vector<LeftOutDistance>& distances);
} // namespace palpate
