// SPDX-License-Identifier: Apache-2.0
//
// The same picture as glass_and_mirror.toml.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 adc_bailout 0.002 }

camera {
  location <0, 2.2, 7>
  right -4/3*x
  up y
  angle degrees(2*atan2(tan(radians(18))*4/3, 1))
  look_at <0, 0.9, 0>
}
background { rgb <0.35, 0.5, 0.7> }
light_source { <5, 8, 6> rgb 0.9 }
light_source { <-6, 5, 3> rgb 0.3 }

#declare Glass = material {
  texture {
    pigment { rgbt 1 }
    finish { ambient 0 diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
  }
  interior { ior 1.5 }
}
#macro Matte(C) texture { pigment { rgb C } finish { ambient 0 diffuse 1 } } #end
#macro Mirror(C) texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection { C } } } #end

plane {
  y, 0
  texture {
    pigment { checker rgb <0.85, 0.85, 0.85>, rgb <0.15, 0.2, 0.25> translate -0.0001 }
    finish { ambient 0 diffuse 1 }
  }
}
polygon {
  5, <-3, 0.05, -2.5>, <3, 0.05, -2.5>, <3, 2.65, -2.5>, <-3, 2.65, -2.5>, <-3, 0.05, -2.5>
  Mirror(<0.85, 0.88, 0.9>)
}
sphere { <-1.3, 0.801, 1>, 0.8 material { Glass } }
difference {
  sphere { <0.35, 0.701, 2.2>, 0.7 }
  sphere { <0.35, 0.701, 2.2>, 0.62 }
  material { Glass }
}
sphere { <1.7, 0.9, 0.2>, 0.9 Mirror(rgb 0.8) }
sphere { <0, 0.5, -0.8>, 0.5 Matte(<0.75, 0.12, 0.08>) }
box { <-2.9, 0, -1.2>, <-2.1, 0.8, -0.4> Matte(<0.8, 0.6, 0.1>) }
