//! Metrics of the gallery, by the names and parameters of a file.

use std::ops::Range;

use tautline::{
    ANY, Formula, Metric,
    gallery::{self as metrics, GalleryError},
};

use tautline_any::{InDimension, LARGEST_FIXED_DIMENSION, in_dimension, vector};

use crate::{
    Diagnostic,
    file::gallery::{self as files, GalleryFile},
    reading::numbers::{Numbers, counted},
};

/// Why a metric of the gallery was refused.
enum Refused {
    /// A number is not one.
    Number(Diagnostic),
    /// A parameter is out of range.
    Gallery(GalleryError),
    /// The metric exists in another dimension, or a list of parameters has another length.
    Count(String),
}

impl From<Diagnostic> for Refused {
    fn from(diagnostic: Diagnostic) -> Self {
        Refused::Number(diagnostic)
    }
}

impl From<GalleryError> for Refused {
    fn from(error: GalleryError) -> Self {
        Refused::Gallery(error)
    }
}

/// Returns the formula of a metric of the gallery in this dimension.
pub(crate) fn formula(
    metric: &GalleryFile,
    at: Range<usize>,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Formula<ANY>, Diagnostic> {
    let refuse = |refused| match refused {
        Refused::Number(diagnostic) => diagnostic,
        Refused::Gallery(error) => Diagnostic::new(error.to_string(), at.clone()),
        Refused::Count(message) => Diagnostic::new(message, at.clone()),
    };
    let in_plane = InPlane { metric, numbers, dimension };
    if let Some(formula) = in_plane.formula().map_err(refuse)? {
        return Ok(formula);
    }
    let formula = in_dimension(dimension, InAny { metric, numbers });
    formula
        .unwrap_or_else(|| {
            Err(Refused::Count(format!(
                "the gallery has metrics in up to {LARGEST_FIXED_DIMENSION} dimensions, not {dimension}"
            )))
        })
        .map_err(refuse)
}

fn recorded<const D: usize>(metric: &impl Metric<D>) -> Result<Formula<ANY>, Refused> {
    let formula = Formula::<D>::record(metric);
    let formula = formula.map_err(|error| Refused::Count(error.to_string()))?;
    Ok(formula.into_any())
}

/// A metric that exists in one dimension only.
struct InPlane<'q> {
    metric: &'q GalleryFile,
    numbers: &'q Numbers<'q>,
    dimension: usize,
}

impl InPlane<'_> {
    /// Returns the formula, or `None` if the metric exists in any dimension.
    fn formula(&self) -> Result<Option<Formula<ANY>>, Refused> {
        let number = |text| self.numbers.number(text);
        let only = |dimension: usize| {
            let what = format!(
                "this metric has {}, not {}",
                counted(dimension, "coordinate"),
                self.dimension
            );
            if dimension == self.dimension { Ok(()) } else { Err(Refused::Count(what)) }
        };
        let pair = |texts: &[_]| {
            let found = counted(texts.len(), "number");
            <[f64; 2]>::try_from(self.numbers.all(texts)?)
                .map_err(|_| Refused::Count(format!("{found} where 2 are needed")))
        };
        let plane = || only(2);
        let formula = match self.metric {
            GalleryFile::Ramp(files::Ramp { amplitude, wave_number }) => {
                only(1)?;
                recorded(&metrics::Ramp::new(number(amplitude)?, number(wave_number)?)?)
            }
            GalleryFile::Shear(files::Shear { amplitude, wave_number }) => {
                plane()?;
                recorded(&metrics::Shear::new(number(amplitude)?, number(wave_number)?)?)
            }
            GalleryFile::Swirl(files::Swirl { angle, width }) => {
                plane()?;
                recorded(&metrics::Swirl::new(number(angle)?, number(width)?)?)
            }
            GalleryFile::EggCrate(files::EggCrate { amplitude, wave_number }) => {
                plane()?;
                recorded(&metrics::EggCrate::new(number(amplitude)?, number(wave_number)?)?)
            }
            GalleryFile::Checkerboard(files::Checkerboard { height, cell }) => {
                plane()?;
                recorded(&metrics::Checkerboard::new(number(height)?, number(cell)?)?)
            }
            GalleryFile::TwoChannels(files::TwoChannels { height, offset, width }) => {
                plane()?;
                let [height, offset, width] = [height, offset, width].map(number);
                recorded(&metrics::TwoChannels::new(height?, offset?, width?)?)
            }
            GalleryFile::RotatingAnisotropy(files::RotatingAnisotropy {
                eigenvalues,
                wave_vector,
            }) => {
                plane()?;
                let (eigenvalues, wave_vector) = (pair(eigenvalues)?, pair(wave_vector)?);
                recorded(&metrics::RotatingAnisotropy::new(eigenvalues, wave_vector)?)
            }
            GalleryFile::TwoLinkArm(files::TwoLinkArm { a, b, c }) => {
                plane()?;
                recorded(&metrics::TwoLinkArm::new(number(a)?, number(b)?, number(c)?)?)
            }
            GalleryFile::CoupledCosines(_) => {
                only(3)?;
                recorded(&metrics::CoupledCosines)
            }
            GalleryFile::GaussianFisher(_) => {
                plane()?;
                recorded(&metrics::GaussianFisher)
            }
            GalleryFile::GaussianFisherPatch(files::GaussianFisherPatch { rim }) => {
                plane()?;
                recorded(&metrics::GaussianFisherPatch::new(number(rim)?)?)
            }
            _ => return Ok(None),
        };
        formula.map(Some)
    }
}

/// A metric that exists in any dimension.
struct InAny<'q> {
    metric: &'q GalleryFile,
    numbers: &'q Numbers<'q>,
}

impl InDimension for InAny<'_> {
    type Output = Result<Formula<ANY>, Refused>;

    fn run<const D: usize>(self) -> Self::Output {
        let number = |text| self.numbers.number(text);
        let coordinates = |texts: &[_]| {
            let found = counted(texts.len(), "number");
            if texts.len() != D {
                return Err(Refused::Count(format!("{found} where {D} are needed")));
            }
            Ok(vector::<D>(&self.numbers.all(texts)?))
        };
        match self.metric {
            GalleryFile::Valleys(_) => recorded::<D>(&metrics::Valleys),
            GalleryFile::Separable(files::Separable { amplitudes, wave_numbers }) => {
                let numbers = (coordinates(amplitudes)?, coordinates(wave_numbers)?);
                recorded::<D>(&metrics::Separable::new(numbers.0, numbers.1)?)
            }
            GalleryFile::Lens(files::Lens { height, width }) => {
                recorded::<D>(&metrics::Lens::new(number(height)?, number(width)?)?)
            }
            GalleryFile::Bump(files::Bump { height, width }) => {
                recorded::<D>(&metrics::Bump::new(number(height)?, number(width)?)?)
            }
            GalleryFile::Hill(files::Hill { height, width }) => {
                recorded::<D>(&metrics::Hill::new(number(height)?, number(width)?)?)
            }
            GalleryFile::SoftObstacles(files::SoftObstacles { obstacles }) => {
                let obstacles = obstacles.iter().map(|obstacle| {
                    let (centre, height) =
                        (coordinates(&obstacle.centre)?, number(&obstacle.height)?);
                    Ok(metrics::Obstacle { centre, height, width: number(&obstacle.width)? })
                });
                let obstacles = obstacles.collect::<Result<Vec<_>, Refused>>()?;
                recorded::<D>(&metrics::SoftObstacles::new(obstacles)?)
            }
            GalleryFile::Corrugated(files::Corrugated { amplitude, wave_number }) => {
                recorded::<D>(&metrics::Corrugated::new(number(amplitude)?, number(wave_number)?)?)
            }
            GalleryFile::Sphere(_) => recorded::<D>(&metrics::Sphere),
            GalleryFile::Hyperbolic(_) => recorded::<D>(&metrics::Hyperbolic),
            GalleryFile::SpherePatch(files::SpherePatch { radius }) => {
                recorded::<D>(&metrics::SpherePatch::new(number(radius)?)?)
            }
            GalleryFile::HyperbolicPatch(files::HyperbolicPatch { radius }) => {
                recorded::<D>(&metrics::HyperbolicPatch::new(number(radius)?)?)
            }
            _ => Err(Refused::Count("this metric does not exist in every dimension".to_owned())),
        }
    }
}
