use super::*;

#[test]
fn sums_of_all_metrics_are_those_of_each_seed() {
    let seeds = Seeds::of([3, -2, 5]);
    let p = DVec3::new(3.3, -1.6, 5.9);
    for metric in [1.0, 2.0, 2.5, 3.0, 0.3, 2.2, 9.0, 31.7, 33.3, 300.0, 1000.0, -1.0, -2.2] {
        let metric = Metric::new(metric);
        let sums = seeds.sums(p, metric);
        for (place, sum) in sums[..ADJACENT].iter().enumerate() {
            let right = metric.sum(p - seeds.at(place));
            assert!((sum - right).abs() <= 1e-13 * right, "{metric:?} {place}: {sum}");
        }
        assert!(sums[ADJACENT..].iter().all(|sum| *sum == f64::INFINITY), "{metric:?}");
    }
}

#[test]
fn distances_of_four_sums_are_those_of_each() {
    let sums = Lanes([0.3, 1.7, -0.2, 0.0]);
    for metric in [1.0, 2.0, 2.5, 3.0, 0.3, 0.5, 2.2, 9.0, 300.0, -1.0, -2.2] {
        let metric = Metric::new(metric);
        for sums in [sums, sums.abs()] {
            let distances = metric.distances(sums);
            for (sum, distance) in sums.0.into_iter().zip(distances.0) {
                let right = metric.distance(sum);
                let same = distance == right || distance.is_nan() && right.is_nan();
                assert!(same || (distance - right).abs() <= 1e-14 * right, "{metric:?} {sum}: {distance}");
            }
        }
    }
}
