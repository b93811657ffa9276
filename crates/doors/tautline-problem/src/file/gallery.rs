//! `GalleryFile`: a metric of the gallery in a file, with its parameters.

use std::{borrow::Cow, fmt, iter};

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{
    Deserialize, Deserializer,
    de::{
        self,
        value::{MapAccessDeserializer, MapDeserializer},
    },
};

use super::expression::Text;

/// A metric of the gallery, as a table with its name and parameters, or by its name alone if it
/// has no parameters.
#[derive(Clone, Debug)]
pub(crate) struct FromGallery(pub(crate) GalleryFile);

/// The metrics whose name alone says which one is meant.
const WITHOUT_PARAMETERS: [&str; 5] =
    ["valleys", "coupled_cosines", "sphere", "hyperbolic", "gaussian_fisher"];

impl JsonSchema for FromGallery {
    fn schema_name() -> Cow<'static, str> {
        "FromGallery".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "anyOf": [
                { "description": "A metric without parameters.", "enum": WITHOUT_PARAMETERS },
                generator.subschema_for::<GalleryFile>(),
            ],
        })
    }
}

impl<'de> Deserialize<'de> for FromGallery {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl<'de> de::Visitor<'de> for Visitor {
            type Value = FromGallery;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a metric such as { shear = { amplitude = 0.5, wave_number = 1 } }")
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Self::Value, E> {
                let none = MapDeserializer::new(iter::empty::<(&str, &str)>());
                let table = MapDeserializer::new(iter::once((name, none)));
                GalleryFile::deserialize(MapAccessDeserializer::new(table)).map(FromGallery)
            }

            fn visit_map<A: de::MapAccess<'de>>(
                self,
                mut table: A,
            ) -> Result<Self::Value, A::Error> {
                let found = GalleryFile::deserialize(MapAccessDeserializer::new(&mut table))?;
                match table.next_key::<String>()? {
                    None => Ok(FromGallery(found)),
                    Some(other) => Err(de::Error::custom(format_args!(
                        "a second metric, {other}: expected one; sum adds several"
                    ))),
                }
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

/// Defines [`GalleryFile`] and the gallery's names. Each metric has its name, the dimensions in
/// which it exists (0 stands for any), and its parameters.
macro_rules! gallery {
    ($($(#[$doc:meta])* $name:ident { $($(#[$of:meta])* $field:ident: $type:ty,)* })*) => {
        /// A metric of the gallery.
        #[derive(Clone, Debug, Deserialize, JsonSchema)]
        #[serde(rename_all = "snake_case")]
        pub(crate) enum GalleryFile {
            $($(#[$doc])* $name($name),)*
        }
        $(
            $(#[$doc])*
            #[derive(Clone, Debug, Deserialize, JsonSchema)]
            #[serde(deny_unknown_fields)]
            pub(crate) struct $name {
                $($(#[$of])* pub(crate) $field: $type,)*
            }
        )*
    };
}

/// An obstacle.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ObstacleFile {
    /// The centre.
    pub(crate) centre: Vec<Text>,
    /// The height above 1, at least 0.
    pub(crate) height: Text,
    /// The width of the Gaussian.
    pub(crate) width: Text,
}

gallery! {
    /// `(2 − cos x₁)² I`, in any dimension.
    Valleys {}
    /// `(1 + a tanh kx)²`, on the line.
    Ramp {
        /// The amplitude `a`, below 1.
        amplitude: Text,
        /// The wave number `k`.
        wave_number: Text,
    }
    /// `diag((1 + aᵢ sin kᵢxᵢ)²)`, in any dimension.
    Separable {
        /// The amplitudes `aᵢ`, below 1.
        amplitudes: Vec<Text>,
        /// The wave numbers `kᵢ`.
        wave_numbers: Vec<Text>,
    }
    /// `JᵀJ` of `(x₁ + a sin kx₂, x₂)`, in the plane.
    Shear {
        /// The amplitude `a`.
        amplitude: Text,
        /// The wave number `k`.
        wave_number: Text,
    }
    /// `(1 + a e^{−r²/2s²}) I`, in any dimension.
    Lens {
        /// The height `a`.
        height: Text,
        /// The width `s`.
        width: Text,
    }
    /// `(1 + a e^{−r²/2s²})² I`, in any dimension.
    Bump {
        /// The height `a`.
        height: Text,
        /// The width `s`.
        width: Text,
    }
    /// `I + ∇f ∇fᵀ` of `f = h e^{−r²/2s²}`, in any dimension.
    Hill {
        /// The height `h`.
        height: Text,
        /// The width `s`.
        width: Text,
    }
    /// `(1 + Σ aᵢ e^{−rᵢ²/2sᵢ²}) I`, in any dimension.
    SoftObstacles {
        /// The obstacles.
        obstacles: Vec<ObstacleFile>,
    }
    /// `JᵀJ` of `R(α e^{−r²/2s²}) x`, in the plane.
    Swirl {
        /// The angle `α` in the middle.
        angle: Text,
        /// The width `s`.
        width: Text,
    }
    /// `I + ∇f ∇fᵀ` of `f = a (sin kx₁ + sin kx₂)`, in the plane.
    EggCrate {
        /// The amplitude `a`.
        amplitude: Text,
        /// The wave number `k`.
        wave_number: Text,
    }
    /// `I + f′² e₁e₁ᵀ` of `f = a sin kx₁`, in any dimension.
    Corrugated {
        /// The amplitude `a`.
        amplitude: Text,
        /// The wave number `k`.
        wave_number: Text,
    }
    /// `(1 + a sin²(πx₁/e) sin²(πx₂/e)) I`, in the plane.
    Checkerboard {
        /// The height `a`.
        height: Text,
        /// The edge `e` of a cell.
        cell: Text,
    }
    /// `(1 + a Π (1 − e^{−(x₂ ∓ b)²/2s²})) I`, in the plane.
    TwoChannels {
        /// The height `a`.
        height: Text,
        /// The offset `b` of the channels.
        offset: Text,
        /// The width `s` of the channels.
        width: Text,
    }
    /// `Q(k·x) diag(λ₁, λ₂) Q(k·x)ᵀ`, in the plane.
    RotatingAnisotropy {
        /// The eigenvalues `λ₁` and `λ₂`.
        eigenvalues: Vec<Text>,
        /// The wave vector `k`.
        wave_vector: Vec<Text>,
    }
    /// The kinetic energy of a robot arm with two links, by its two angles.
    TwoLinkArm {
        /// The constant part of the first entry.
        a: Text,
        /// The coupling.
        b: Text,
        /// The second entry.
        c: Text,
    }
    /// `diag + ⅖ cos(xᵢ − xⱼ) / (1 + |i − j|)`, in space.
    CoupledCosines {}
    /// The sphere by stereographic projection, `4 / (1 + r²)² I`, in any dimension.
    Sphere {}
    /// Hyperbolic space in the unit ball, `4 / (1 − r²)² I`, in any dimension.
    Hyperbolic {}
    /// Normal distributions by mean and logarithm of the deviation, `diag(e^{−2t}, 2)`.
    GaussianFisher {}
    /// The sphere up to `r ≤ R`, and constant far outside.
    SpherePatch {
        /// The radius `R` of the patch.
        radius: Text,
    }
    /// Hyperbolic space up to `r ≤ R`, and constant far outside.
    HyperbolicPatch {
        /// The radius `R < 0.86` of the patch.
        radius: Text,
    }
    /// Normal distributions up to `|t| ≤ T`, and constant far outside.
    GaussianFisherPatch {
        /// The rim `T` of the strip.
        rim: Text,
    }
}
