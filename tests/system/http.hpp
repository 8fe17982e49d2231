// SPDX-License-Identifier: Apache-2.0
// cpp-httplib, without a macro of resolv.h that Eigen does not bear.
#pragma once

#include <httplib.h>

#undef _res
