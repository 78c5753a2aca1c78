// SPDX-License-Identifier: Apache-2.0
// The headers of robot/openr compiled for the robot: what they assert of sizes and places must hold
// with its 32-bit pointers too. Nothing of this file is linked.
#include <OPENR/ODataFormats.h>
#include <OPENR/OFbkImage.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSubject.h>
#include <OPENR/RCRegion.h>
