// The texts of the models in tamp/robots/models, put in when Praxis is configured.
#pragma once

namespace praxis::tamp::models {

extern const char* const kArmUrdf;
extern const char* const kArmSrdf;
extern const char* const kArmLimits;
extern const char* const kPlatformUrdf;
extern const char* const kPlatformSrdf;
extern const char* const kPlatformLimits;

}  // namespace praxis::tamp::models
